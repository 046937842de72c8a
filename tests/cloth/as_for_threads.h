#pragma once
// Loops cut as for some threads, whatever machine runs them.

#include "engine/threads/parallel_blocks.h"

namespace weft::test {

/// Cut as for so many threads, but serial, the last part first.
inline Parallel as_for_threads(int threads) {
    Executor executor;
    executor.width = threads;
    executor.run = [](void*, std::uint32_t blocks, Executor::Body body, void* context) {
        while (blocks > 0) body(context, --blocks);
    };
    return Parallel(executor);
}

}  // namespace weft::test
