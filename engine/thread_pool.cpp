#include "engine/thread_pool.h"

namespace weft {

namespace {

// Set while this thread runs a body: a loop inside it must not wait for workers that may be waiting for it.
thread_local bool inside_body = false;

}  // namespace

ThreadPool::ThreadPool(int threads) {
    for (int i = 1; i < threads; ++i) workers_.emplace_back([this] { serve(); });
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    loop_started_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::run(std::uint32_t block_count, Executor::Body body, void* context) {
    if (inside_body) {
        for (std::uint32_t block = 0; block < block_count; ++block) body(context, block);
        return;
    }
    const Loop loop{block_count, body, context};
    {
        const std::lock_guard lock(mutex_);
        loop_ = loop;
        next_block_ = 0;
        working_ = workers_.size();
        ++loop_number_;
    }
    loop_started_.notify_all();
    take_blocks(loop);
    std::unique_lock lock(mutex_);
    workers_done_.wait(lock, [this] { return working_ == 0; });
}

void ThreadPool::serve() {
    std::uint64_t last_loop = 0;
    std::unique_lock lock(mutex_);
    for (;;) {
        loop_started_.wait(lock, [&] { return stopping_ || loop_number_ != last_loop; });
        if (stopping_) return;
        last_loop = loop_number_;
        const Loop loop = loop_;
        lock.unlock();
        take_blocks(loop);
        lock.lock();
        if (--working_ == 0) workers_done_.notify_one();
    }
}

void ThreadPool::take_blocks(const Loop& loop) {
    inside_body = true;
    for (std::uint32_t block; (block = next_block_.fetch_add(1)) < loop.block_count;)
        loop.body(loop.context, block);
    inside_body = false;
}

}  // namespace weft
