#pragma once
// Worker threads from the standard library, in place of the oneTBB arena where every synchronisation has to
// be visible to the thread sanitizer. Built in that configuration only.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "weft/executor.h"

namespace weft {

class ThreadPool {
  public:
    /// Starts threads - 1 workers; the thread that calls run() is the last one.
    explicit ThreadPool(int threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    /// body(context, block) for every block in [0, block_count), each once. From within a body: on the
    /// calling thread.
    void run(std::uint32_t block_count, Executor::Body body, void* context);

  private:
    struct Loop {
        std::uint32_t block_count = 0;
        Executor::Body body = nullptr;
        void* context = nullptr;
    };

    void serve();
    void take_blocks(const Loop& loop);

    std::mutex mutex_;
    std::condition_variable loop_started_, workers_done_;
    Loop loop_;                      // guarded by mutex_, as are the next three
    std::uint64_t loop_number_ = 0;  // workers run each number once
    std::size_t working_ = 0;        // workers that have not finished the present loop
    bool stopping_ = false;
    std::atomic<std::uint32_t> next_block_ = 0;
    std::vector<std::thread> workers_;
};

}  // namespace weft
