#include "engine/parallel_blocks.h"

#include <chrono>
#include <thread>
#include <utility>

#include "engine/loop_team.h"
#include "engine/tracy_zones.h"

#ifdef WEFT_STD_THREADS
#include "engine/helper_threads.h"
#else
#include <tbb/task_arena.h>
#endif

namespace weft {

namespace {

#ifdef WEFT_STD_THREADS
using Helpers = HelperThreads;
#else
class Helpers {
  public:
    Helpers(std::shared_ptr<LoopTeam> team, int threads) : team_(std::move(team)), arena_(threads) {
        arena_.initialize();
    }
    // Late helpers leave at once, but oneTBB has to start them first: a task that never ran would be lost
    // memory. Not for ever: where the process ends, there may be no threads left to start them.
    ~Helpers() {
        using Clock = std::chrono::steady_clock;
        const Clock::time_point limit = Clock::now() + std::chrono::seconds(1);
        constexpr long own = 2;  // holders of the team: this and the arena; each task is one more
        while (team_.use_count() > own && Clock::now() < limit) std::this_thread::yield();
    }
    Helpers(const Helpers&) = delete;
    Helpers& operator=(const Helpers&) = delete;

    void send(std::uint32_t place) {
        arena_.enqueue([team = team_, place] { team->help(place); });
    }

  private:
    std::shared_ptr<LoopTeam> team_;
    tbb::task_arena arena_;
};
#endif

}  // namespace

class Parallel::Arena {
  public:
    explicit Arena(int threads)
        : team_(std::make_shared<LoopTeam>(static_cast<std::uint32_t>(threads))), helpers_(team_, threads) {}
    ~Arena() { team_->close(); }

    void run(std::uint32_t block_count, Executor::Body body, void* context) {
        team_->run(block_count, body, context, [this](std::uint32_t place) { helpers_.send(place); });
    }

  private:
    std::shared_ptr<LoopTeam> team_;
    Helpers helpers_;
};

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
    TraceLog* const log = log_ != nullptr && log_->is_on() ? log_ : nullptr;
    if (log == nullptr && !with_tracy) {
        executor_.run(executor_.user, block_count, body, context);
        return;
    }
    struct Traced {
        TraceLog* log;
        std::uint64_t loop;
        const char* name;
        Executor::Body body;
        void* context;
    } traced{log, TraceLog::new_loop(), NamedActivity::current(), body, context};
    executor_.run(
        executor_.user, block_count,
        [](void* of, std::uint32_t block) noexcept {
            const Traced& loop = *static_cast<const Traced*>(of);
            const TracyZone zone(loop.name);
            const auto begin = std::chrono::steady_clock::now();
            loop.body(loop.context, block);
            if (loop.log != nullptr)
                loop.log->add_block(loop.loop, loop.name, begin, std::chrono::steady_clock::now());
        },
        &traced);
}

Parallel::Parallel(const Executor& executor) : executor_(executor) {}

Parallel::~Parallel() = default;
Parallel::Parallel(Parallel&&) noexcept = default;
Parallel& Parallel::operator=(Parallel&&) noexcept = default;

}  // namespace weft
