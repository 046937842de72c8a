#pragma once
// Differences between compilers and between systems, so that no other file tests for either.

#include <atomic>
#include <cstdint>

#if defined(__wasm__) && !defined(_REENTRANT)
#define WEFT_WITHOUT_THREADS  // a World has one thread, whatever the host asks for
#endif

#ifdef __wasi__
#define WEFT_WITHOUT_FILES  // WASI's standard library has no file streams; recordings work all the same
#endif

#ifdef __GNUC__  // and clang
#define WEFT_NOT_UNROLLED _Pragma("GCC unroll 1")
#else
#define WEFT_NOT_UNROLLED
#endif

namespace weft {

/// Number of this machine's hardware threads; 0: not known.
[[nodiscard]] int hardware_threads() noexcept;
void yield_thread() noexcept;

/// Stores a value that several threads may write at once, all of them the same.
inline void store_relaxed(std::uint8_t& to, std::uint8_t value) noexcept {
#ifdef __cpp_lib_atomic_ref
    std::atomic_ref<std::uint8_t>(to).store(value, std::memory_order_relaxed);
#else  // libc++ before 19
    __atomic_store_n(&to, value, __ATOMIC_RELAXED);
#endif
}

}  // namespace weft
