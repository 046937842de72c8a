#include "engine/threads/parallel_blocks.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

#include "engine/memory/without_exceptions.h"
#include "engine/platform.h"
#include "engine/profiling/tracy_zones.h"
#include "engine/threads/host_team.h"
#include "engine/threads/loop_team.h"

#if defined(WEFT_STD_THREADS) && !defined(WEFT_WITHOUT_THREADS)
#include "engine/threads/helper_threads.h"
#elif !defined(WEFT_STD_THREADS)
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

namespace weft {

namespace {

[[maybe_unused]] constexpr int max_threads = 256;

// Longest wait of a helper for the next loop. Between steps it leaves, so that oneTBB's threads can sleep.
constexpr std::chrono::microseconds patience{200};

#if defined(WEFT_WITHOUT_THREADS)
struct Helpers {
    Helpers(const std::shared_ptr<LoopTeam>&, int, LoopTeam::Duration) {}
    bool send(std::uint32_t) noexcept { return false; }
};

int available_threads() {
    return 1;
}
#elif defined(WEFT_STD_THREADS)
using Helpers = HelperThreads;

int available_threads() {
    return max_threads;
}
#else
class Helpers {
  public:
    Helpers(std::shared_ptr<LoopTeam> team, int threads, LoopTeam::Duration waiting)
        : team_(std::move(team)), waiting_(waiting), arena_(threads) {
        arena_.initialize();
    }
    // Late helpers leave at once, but oneTBB has to start them first, or their tasks' memory would be lost.
    // The wait is limited: where the process ends, there may be no threads left to start them.
    ~Helpers() {
        using Clock = std::chrono::steady_clock;
        const Clock::time_point limit = Clock::now() + std::chrono::seconds(1);
        constexpr long own = 2;  // holders of the team: this and the arena; each task is one more
        while (team_.use_count() > own && Clock::now() < limit) yield_thread();
    }
    Helpers(const Helpers&) = delete;
    Helpers& operator=(const Helpers&) = delete;

    bool send(std::uint32_t place) noexcept {
        return comes_through([&] {
            arena_.enqueue([team = team_, place, waiting = waiting_] { team->help(place, waiting); });
        });
    }

  private:
    std::shared_ptr<LoopTeam> team_;
    LoopTeam::Duration waiting_;
    tbb::task_arena arena_;
};

// If asked for more threads than it allows, oneTBB starts none of them and says so on standard error.
int available_threads() {
    using tbb::global_control;
    return static_cast<int>(std::min<std::size_t>(
        global_control::active_value(global_control::max_allowed_parallelism), max_threads));
}
#endif

}  // namespace

class Parallel::Arena {
  public:
    explicit Arena(int threads)
        : team_(std::make_shared<LoopTeam>(static_cast<std::uint32_t>(threads))),
          helpers_(team_, threads, patience) {}
    ~Arena() { team_->close(); }

    void run(std::uint32_t block_count, Executor::Body body, void* context) {
        team_->run(block_count, body, context, [this](std::uint32_t place) { return helpers_.send(place); });
    }

  private:
    std::shared_ptr<LoopTeam> team_;
    Helpers helpers_;
};

Parallel::Parallel(int threads) : width_(std::min(threads, available_threads())) {
    if (width_ > 1) arena_ = std::make_unique<Arena>(width_);
}

Parallel::Parallel(const Executor& executor) : width_(executor.width) {
    if (width_ > 1) host_ = std::make_unique<HostTeam>(executor);
}

void Parallel::lend(void (*step)(void* context), void* context) noexcept {
    if (host_ && !host_->is_lent())
        host_->lend(step, context);
    else
        step(context);
}

void Parallel::run(std::uint32_t block_count, Executor::Body body, void* context) {
    TraceLog* const log = log_ != nullptr && log_->is_on() ? log_ : nullptr;
    if (log == nullptr && !with_tracy) {
        spread(block_count, body, context);
        return;
    }
    struct Traced {
        TraceLog* log;
        std::uint64_t loop;
        const char* name;
        Executor::Body body;
        void* context;
    } traced{log, TraceLog::new_loop(), NamedActivity::current(), body, context};
    spread(
        block_count,
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

void Parallel::spread(std::uint32_t block_count, Executor::Body body, void* context) {
    if (arena_)
        arena_->run(block_count, body, context);
    else
        host_->run(block_count, body, context);
}

Parallel::~Parallel() = default;
Parallel::Parallel(Parallel&&) noexcept = default;
Parallel& Parallel::operator=(Parallel&&) noexcept = default;

}  // namespace weft
