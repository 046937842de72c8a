#pragma once
// How a host lends its own threads to Weft.

#include <cstdint>

namespace weft {

/// Runs `body(context, block)` once for every block in [0, block_count), on whatever threads it likes, in any
/// order, also one block after the other on one thread, and returns when all are done.
///
/// A World calls `run` once in each World::step, move_cloth, reset_cloth and shift_origin and at no other
/// time, with `width` blocks. The first block to begin is the step, on the thread that begins it. The others
/// help with it and return when it ends: a thread that helps is busy for as long as the step takes. Results
/// do not depend on the order or on the threads.
///
/// With `run` null (the default) Weft uses threads of its own: a oneTBB arena, or with WEFT_TBB=OFF the
/// standard library's.
struct Executor {
    using Body = void (*)(void* context, std::uint32_t block) noexcept;

    /// Must not throw.
    void (*run)(void* user, std::uint32_t block_count, Body body, void* context) = nullptr;
    void* user = nullptr;  ///< passed back to `run`
    /// Threads that share a step, 1 to 256: as many as can run at the same time; never seen in a result. At 1
    /// `run` is not called, and the step is taken by the thread that calls World::step.
    int width = 1;
};

}  // namespace weft
