#pragma once
// The host's threads, lent for as long as one step takes.

#include <atomic>
#include <cstdint>

#include "engine/threads/loop_team.h"
#include "weft/executor.h"

namespace weft {

/// One call of the executor lends its threads: the first of its blocks to begin is the step, and the others
/// help with the step's loops until it ends. A helper comes only after the step has begun, and the step waits
/// for no helper that has not taken a block of a loop. So the executor may run the blocks on as few threads,
/// and in any order, as it likes.
class HostTeam {
  public:
    /// Precondition: executor.run is set, 2 <= executor.width.
    explicit HostTeam(const Executor& executor)
        : executor_(executor), team_(static_cast<std::uint32_t>(executor.width)) {}

    /// Runs step(context) on one of the host's threads, while the others watch for its loops. Not from
    /// within a step.
    void lend(void (*step)(void* context), void* context) noexcept;

    /// Whether a step is being run. Only the step's own thread and bodies of its loops may ask.
    [[nodiscard]] bool is_lent() const noexcept { return is_lent_; }

    /// Runs all blocks: with the helpers, or on the calling thread alone if no step is being run.
    void run(std::uint32_t block_count, Executor::Body body, void* context);

  private:
    void arrive() noexcept;

    Executor executor_;
    LoopTeam team_;
    void (*step_)(void* context) = nullptr;
    void* context_ = nullptr;
    std::atomic<std::uint32_t> arrived_ = 0;  // blocks of the executor that have begun
    bool is_lent_ = false;                    // the step's thread writes it, outside of all loops
};

}  // namespace weft
