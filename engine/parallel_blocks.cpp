#include "engine/parallel_blocks.h"

#ifdef WEFT_STD_THREADS
#include "engine/thread_pool.h"
#else
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#endif

namespace weft {

#ifdef WEFT_STD_THREADS

class Parallel::Arena : public ThreadPool {
  public:
    using ThreadPool::ThreadPool;
};

#else

class Parallel::Arena {
  public:
    explicit Arena(int threads) : arena_(threads) { arena_.initialize(); }

    void run(std::uint32_t block_count, Executor::Body body, void* context) {
        arena_.execute([=] {
            tbb::parallel_for(
                tbb::blocked_range<std::uint32_t>(0, block_count),
                [=](const tbb::blocked_range<std::uint32_t>& blocks) {
                    for (std::uint32_t block = blocks.begin(); block < blocks.end(); ++block)
                        body(context, block);
                },
                tbb::static_partitioner());
        });
    }

  private:
    tbb::task_arena arena_;
};

#endif

Parallel::Parallel(int threads) {
    executor_.width = threads;
    if (threads == 1) return;
    arena_ = std::make_unique<Arena>(threads);
    executor_.user = arena_.get();
    executor_.run = [](void* arena, std::uint32_t block_count, Executor::Body body, void* context) {
        static_cast<Arena*>(arena)->run(block_count, body, context);
    };
}

void Parallel::run(std::uint32_t block_count, Executor::Body body, void* context) {
    if (log_ == nullptr || !log_->is_on()) {
        executor_.run(executor_.user, block_count, body, context);
        return;
    }
    struct Traced {
        TraceLog& log;
        std::uint64_t loop;
        const char* name;
        Executor::Body body;
        void* context;
    } traced{*log_, TraceLog::new_loop(), NamedActivity::current(), body, context};
    executor_.run(
        executor_.user, block_count,
        [](void* of, std::uint32_t block) noexcept {
            const Traced& loop = *static_cast<const Traced*>(of);
            const auto begin = std::chrono::steady_clock::now();
            loop.body(loop.context, block);
            loop.log.add_block(loop.loop, loop.name, begin, std::chrono::steady_clock::now());
        },
        &traced);
}

Parallel::Parallel(const Executor& executor) : executor_(executor) {}

Parallel::~Parallel() = default;
Parallel::Parallel(Parallel&&) noexcept = default;
Parallel& Parallel::operator=(Parallel&&) noexcept = default;

}  // namespace weft
