#include "tests/guarantees/allocation_count.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::uint64_t> allocations = 0;
std::atomic<std::int64_t> bytes = 0;

std::atomic<bool> running_out = false, ran_out = false, for_good = false;
std::atomic<std::int64_t> left = 0;

bool runs_out_now() noexcept {
    if (!running_out || left-- > 0) return false;
    if (!for_good && ran_out) return false;
    ran_out = true;
    return true;
}

void* allocate(std::size_t size, std::size_t alignment) noexcept {
    ++allocations;
    if (runs_out_now()) return nullptr;
    // aligned_alloc wants whole multiples of the alignment.
    const std::size_t whole = (size + alignment - 1) / alignment * alignment;
    void* const memory = std::aligned_alloc(alignment, whole == 0 ? alignment : whole);
    bytes += static_cast<std::int64_t>(malloc_usable_size(memory));
    return memory;
}

void release(void* memory) noexcept {
    bytes -= static_cast<std::int64_t>(malloc_usable_size(memory));
    std::free(memory);
}

void* allocate_or_throw(std::size_t size, std::size_t alignment) {
    if (void* const memory = allocate(size, alignment)) return memory;
#ifdef __cpp_exceptions
    throw std::bad_alloc();
#else
    std::abort();
#endif
}

constexpr std::size_t plain = __STDCPP_DEFAULT_NEW_ALIGNMENT__;
constexpr std::size_t value(std::align_val_t alignment) {
    return static_cast<std::size_t>(alignment);
}

}  // namespace

namespace weft {

std::uint64_t allocation_count() noexcept {
    return allocations;
}

std::int64_t allocated_bytes() noexcept {
    return bytes;
}

MemoryRunsOut::MemoryRunsOut(std::uint64_t allowed, For how_long) noexcept {
    left = static_cast<std::int64_t>(allowed);
    ran_out = false;
    for_good = how_long == For::good;
    running_out = true;
}

MemoryRunsOut::~MemoryRunsOut() {
    running_out = false;
}

bool MemoryRunsOut::happened() const noexcept {
    return ran_out;
}

}  // namespace weft

void* operator new(std::size_t n) {
    return allocate_or_throw(n, plain);
}
void* operator new[](std::size_t n) {
    return allocate_or_throw(n, plain);
}
void* operator new(std::size_t n, std::align_val_t a) {
    return allocate_or_throw(n, value(a));
}
void* operator new[](std::size_t n, std::align_val_t a) {
    return allocate_or_throw(n, value(a));
}
void* operator new(std::size_t n, const std::nothrow_t&) noexcept {
    return allocate(n, plain);
}
void* operator new[](std::size_t n, const std::nothrow_t&) noexcept {
    return allocate(n, plain);
}
void* operator new(std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept {
    return allocate(n, value(a));
}
void* operator new[](std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept {
    return allocate(n, value(a));
}

void operator delete(void* p) noexcept {
    release(p);
}
void operator delete[](void* p) noexcept {
    release(p);
}
void operator delete(void* p, std::size_t) noexcept {
    release(p);
}
void operator delete[](void* p, std::size_t) noexcept {
    release(p);
}
void operator delete(void* p, std::align_val_t) noexcept {
    release(p);
}
void operator delete[](void* p, std::align_val_t) noexcept {
    release(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept {
    release(p);
}
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept {
    release(p);
}
void operator delete(void* p, const std::nothrow_t&) noexcept {
    release(p);
}
void operator delete[](void* p, const std::nothrow_t&) noexcept {
    release(p);
}
void operator delete(void* p, std::align_val_t, const std::nothrow_t&) noexcept {
    release(p);
}
void operator delete[](void* p, std::align_val_t, const std::nothrow_t&) noexcept {
    release(p);
}
