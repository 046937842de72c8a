#pragma once
// How a host lends its own threads to Weft.

#include <cstdint>

namespace weft {

/// Runs `body(context, block)` once for every block in [0, block_count), on whatever threads it likes, and
/// returns when all are done. Weft's results do not depend on the order or on the threads: a body knows its
/// block only. A World never calls `run` from within a body.
///
/// With `run` null (the default) Weft uses a oneTBB arena of its own.
struct Executor {
    using Body = void (*)(void* context, std::uint32_t block) noexcept;

    void (*run)(void* user, std::uint32_t block_count, Body body, void* context) = nullptr;
    void* user = nullptr;  ///< passed back to `run`
    int width = 1;  ///< threads that `run` uses, 1 to 256; a hint for splitting work, never seen in a result
};

}  // namespace weft
