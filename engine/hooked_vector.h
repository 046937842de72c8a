#pragma once
// A vector whose memory goes through the host's hooks, as an AlignedBuffer's does.

#include <cstddef>
#include <vector>

#include "engine/hooks.h"

namespace weft {

template <class T>
struct HookedAllocator {
    using value_type = T;

    HookedAllocator() = default;
    template <class Other>
    HookedAllocator(const HookedAllocator<Other>& /*other*/) noexcept {
    }  // NOLINT(google-explicit-constructor)

    [[nodiscard]] T* allocate(std::size_t count) { return static_cast<T*>(take_memory(count * sizeof(T))); }
    void deallocate(T* memory, std::size_t count) noexcept { give_memory_back(memory, count * sizeof(T)); }
    friend bool operator==(const HookedAllocator& /*one*/, const HookedAllocator& /*other*/) noexcept {
        return true;
    }
};

/// For what grows with the particles; what is a handful of items may be any vector.
template <class T>
using HookedVector = std::vector<T, HookedAllocator<T>>;

}  // namespace weft
