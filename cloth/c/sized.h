#pragma once
// Structs that begin with struct_size, between a host and a library of which either may be the newer one.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "cloth/c/errors.h"

namespace weft::c {

/// What the struct had in the first version: no host has less of it. A struct that grows says here how long
/// it was.
template <class Sized>
inline constexpr std::size_t first_size = sizeof(Sized);

/// Error: `size` is neither `first` nor `known`, nor between them.
[[nodiscard]] Result<void> check_size(const char* name, std::size_t size, std::size_t first,
                                      std::size_t known);

template <class Sized>
[[nodiscard]] Result<void> check_size(const char* name, std::size_t size) {
    static_assert(std::is_trivially_copyable_v<Sized> && offsetof(Sized, struct_size) == 0);
    return check_size(name, size, first_size<Sized>, sizeof(Sized));
}

/// As much of `value` as the host knows. Precondition: check_size() has no error.
template <class Sized>
void give(Sized value, std::size_t size, Sized* to) noexcept {
    value.struct_size = static_cast<std::uint32_t>(size);
    std::memcpy(to, &value, std::min(size, sizeof value));
}

/// `value` into what the host gave. Error: null, or a size that is none.
template <class Sized>
[[nodiscard]] Result<void> fill(const char* name, const Sized& value, Sized* to) {
    if (to == nullptr) return null_pointer(name);
    if (auto valid = check_size<Sized>(name, to->struct_size); !valid) return valid;
    give(value, to->struct_size, to);
    return {};
}

/// What the host gave, and of what it does not know the defaults. Null: these alone.
template <class Sized>
[[nodiscard]] Result<Sized> taken(const char* name, const Sized* from, Sized defaults) {
    if (from == nullptr) return defaults;
    if (auto valid = check_size<Sized>(name, from->struct_size); !valid) return valid.error();
    std::memcpy(&defaults, from, from->struct_size);
    return defaults;
}

}  // namespace weft::c
