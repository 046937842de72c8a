#pragma once
// A pool of threads as a host may have one: a mutex, two condition variables, and no thought for Weft.

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "weft/executor.h"

namespace weft::test {

class NaivePool {
  public:
    explicit NaivePool(int threads) {
        for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
    }
    ~NaivePool() {
        {
            const std::lock_guard lock(mutex_);
            is_closed_ = true;
        }
        has_work_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }
    NaivePool(const NaivePool&) = delete;
    NaivePool& operator=(const NaivePool&) = delete;

    /// As a World is given it; `width` need not be the pool's number of threads.
    [[nodiscard]] Executor executor(int width) { return {.run = run, .user = this, .width = width}; }
    /// Times that the executor was called.
    [[nodiscard]] int calls() const { return calls_; }

  private:
    static void run(void* user, std::uint32_t block_count, Executor::Body body, void* context) {
        NaivePool& pool = *static_cast<NaivePool*>(user);
        std::unique_lock lock(pool.mutex_);
        ++pool.calls_;
        pool.body_ = body;
        pool.context_ = context;
        pool.next_ = 0;
        pool.end_ = pool.left_ = block_count;
        pool.has_work_.notify_all();
        pool.is_done_.wait(lock, [&] { return pool.left_ == 0; });
    }

    void work() {
        std::unique_lock lock(mutex_);
        for (;;) {
            has_work_.wait(lock, [this] { return is_closed_ || next_ < end_; });
            if (is_closed_) return;
            const std::uint32_t block = next_++;
            lock.unlock();
            body_(context_, block);
            lock.lock();
            if (--left_ == 0) is_done_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable has_work_, is_done_;
    Executor::Body body_ = nullptr;
    void* context_ = nullptr;
    std::uint32_t next_ = 0, end_ = 0, left_ = 0;  // blocks
    int calls_ = 0;
    bool is_closed_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace weft::test
