#pragma once
// A host's replacements for the process's memory and log, and zones for its profiler.

#include <cstddef>
#include <cstdint>

#include "weft/error.h"
#include "weft/export.h"

namespace weft {

enum class LogLevel : std::uint8_t { note, warning };

/// Hooks of the whole process; a null hook leaves the default. They are called from any thread, at any time,
/// also several at once; none may throw or call Weft.
struct Hooks {
    void* user = nullptr;  ///< passed to every hook

    /// Allocates per-particle memory of cloths: buffers of a multiple of 16 bytes, aligned to 64. If it
    /// returns null, the call that needed memory fails with ErrorCode::out_of_memory and changes nothing.
    /// Small or temporary memory - lists, ids, texts, shapes - comes from operator new, threads from oneTBB.
    void* (*allocate)(void* user, std::size_t bytes, std::size_t alignment) = nullptr;
    /// Releases memory of the same `bytes`. Set both, or neither.
    void (*release)(void* user, void* memory, std::size_t bytes, std::size_t alignment) = nullptr;

    /// Receives notes and warnings, each one line without a line break: flags that a step raised and the one
    /// before did not, with the first cloth concerned; parts of a mesh that were left out or turned.
    void (*log)(void* user, LogLevel level, const char* line) = nullptr;
    /// Called after a failed assertion, a fault of Weft that builds with NDEBUG do not test for. Called in
    /// all builds when the host reads the value of a Result that holds an Error; the condition contains its
    /// message. The process is then aborted, unless the hook does not return.
    void (*failed_assertion)(void* user, const char* condition, const char* file, int line) = nullptr;

    /// Called when a stage of a step begins or ends, on the thread that runs it; stages nest.
    /// World::profile() has their names, which live as long as the process. Set both, or neither.
    void (*begin_zone)(void* user, const char* name) = nullptr;
    void (*end_zone)(void* user, const char* name) = nullptr;
};

/// Sets the hooks, while no cloth exists and no call of Weft runs: best before all else. Errors: one of a
/// pair is missing; memory from the previous hooks is in use.
WEFT_API Result<void> set_hooks(const Hooks& hooks);

/// Memory that buffers hold at present, from Hooks::allocate or without it.
struct MemoryUse {
    std::uint64_t bytes = 0, blocks = 0;
};
[[nodiscard]] WEFT_API MemoryUse memory_in_use() noexcept;

}  // namespace weft
