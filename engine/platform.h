#pragma once
// What differs from compiler to compiler and from system to system, so that no other file asks which it is.

#include <atomic>
#include <cstdint>

#if defined(__wasm__) && !defined(_REENTRANT)
#define WEFT_WITHOUT_THREADS  // a World has one thread, whatever it is told
#endif

#ifdef __wasi__
#define WEFT_WITHOUT_FILES  // no streams of files in its standard library; recordings are written all the
                            // same
#endif

#ifdef __GNUC__  // and clang
#define WEFT_NOT_UNROLLED _Pragma("GCC unroll 1")
#else
#define WEFT_NOT_UNROLLED
#endif

namespace weft {

/// Of this machine; 0: not known.
[[nodiscard]] int hardware_threads() noexcept;
void yield_thread() noexcept;

/// For what any of several threads may write, each the same.
inline void store_relaxed(std::uint8_t& to, std::uint8_t value) noexcept {
#ifdef __cpp_lib_atomic_ref
    std::atomic_ref<std::uint8_t>(to).store(value, std::memory_order_relaxed);
#else  // libc++ before 19
    __atomic_store_n(&to, value, __ATOMIC_RELAXED);
#endif
}

}  // namespace weft
