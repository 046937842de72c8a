#pragma once
// What a host gives Weft in place of what the process has: memory, a log, and zones for its profiler.

#include <cstddef>
#include <cstdint>

#include "weft/error.h"
#include "weft/export.h"

namespace weft {

enum class LogLevel : std::uint8_t { note, warning };

/// Of the whole process. What is null is as without hooks. Called from any thread, at any time, also several
/// times at once; none may throw or call Weft.
struct Hooks {
    void* user = nullptr;  ///< handed back

    /// Per-particle memory of cloths: buffers of a multiple of 16 bytes, aligned to 64. Null: there is none,
    /// and the call that needed it fails with ErrorCode::out_of_memory, nothing changed. What is small, or
    /// held only while something is made - lists, ids, texts, shapes - comes from operator new, threads from
    /// oneTBB.
    void* (*allocate)(void* user, std::size_t bytes, std::size_t alignment) = nullptr;
    /// Of the same bytes. Set both, or neither.
    void (*release)(void* user, void* memory, std::size_t bytes, std::size_t alignment) = nullptr;

    /// What somebody may want to look at: which flags a step raised that the one before did not, and which
    /// cloth first; what was left out of a mesh or turned. One line, without a line break.
    void (*log)(void* user, LogLevel level, const char* line) = nullptr;
    /// An assertion failed: a fault of Weft, which builds with NDEBUG do not look for. In all builds: the
    /// host read the value of a Result that holds an Error, whose message is in the condition. Then the
    /// process is aborted, unless this does not return.
    void (*failed_assertion)(void* user, const char* condition, const char* file, int line) = nullptr;

    /// Stages of a step begin and end, on the thread that takes them, one within the other: see
    /// World::profile() for their names, which live as long as the process. Set both, or neither.
    void (*begin_zone)(void* user, const char* name) = nullptr;
    void (*end_zone)(void* user, const char* name) = nullptr;
};

/// While no cloth is there and no call of Weft runs: best before all else. Errors: one of a pair is missing;
/// there is memory that was got by the hooks of before.
WEFT_API Result<void> set_hooks(const Hooks& hooks);

/// What buffers hold at present, by Hooks::allocate or without it.
struct MemoryUse {
    std::uint64_t bytes = 0, blocks = 0;
};
[[nodiscard]] WEFT_API MemoryUse memory_in_use() noexcept;

}  // namespace weft
