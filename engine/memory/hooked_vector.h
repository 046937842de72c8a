#pragma once
// A vector whose memory goes through the host's hooks, as an AlignedBuffer's does.

#include <cstddef>
#include <type_traits>
#include <vector>

#include "engine/memory/hooks.h"

namespace weft {

template <class T>
struct HookedAllocator {
    using value_type = T;
    using propagate_on_container_move_assignment = std::true_type;

    HookedAllocator() = default;
    template <class Other>
    HookedAllocator(const HookedAllocator<Other>& /*other*/) noexcept {}

    [[nodiscard]] T* allocate(std::size_t count) { return static_cast<T*>(take_memory(bytes(count))); }
    void deallocate(T* memory, std::size_t count) noexcept { give_memory_back(memory, bytes(count)); }
    friend bool operator==(const HookedAllocator& /*one*/, const HookedAllocator& /*other*/) noexcept {
        return true;
    }

  private:
    /// A multiple of 16, as Hooks::allocate documents.
    static constexpr std::size_t bytes(std::size_t count) { return (count * sizeof(T) + 15) / 16 * 16; }
};

/// For lists that grow with the particles; a handful of items may be in any vector.
template <class T>
using HookedVector = std::vector<T, HookedAllocator<T>>;

}  // namespace weft
