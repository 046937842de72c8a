#pragma once
// Structs that begin with struct_size, exchanged by a host and a library of which either may be newer.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "cloth/c/errors.h"

namespace weft::c {

/// Size of the struct in the first version, the least that a host has. A struct that grows specialises it.
template <class Sized>
inline constexpr std::size_t first_size = sizeof(Sized);

/// Error: `size` is not in [first, known].
[[nodiscard]] Result<void> check_size(const char* name, std::size_t size, std::size_t first,
                                      std::size_t known);

template <class Sized>
[[nodiscard]] Result<void> check_size(const char* name, std::size_t size) {
    static_assert(std::is_trivially_copyable_v<Sized> && offsetof(Sized, struct_size) == 0);
    return check_size(name, size, first_size<Sized>, sizeof(Sized));
}

/// Writes as much of `value` as the host's version has. Precondition: check_size() has no error.
template <class Sized>
void give(Sized value, std::size_t size, Sized* to) noexcept {
    value.struct_size = static_cast<std::uint32_t>(size);
    std::memcpy(to, &value, std::min(size, sizeof value));
}

/// Writes `value` to the host's struct. Error: null, or an invalid size.
template <class Sized>
[[nodiscard]] Result<void> fill(const char* name, const Sized& value, Sized* to) {
    if (to == nullptr) return null_pointer(name);
    if (auto valid = check_size<Sized>(name, to->struct_size); !valid) return valid;
    give(value, to->struct_size, to);
    return {};
}

/// The host's struct, with the defaults of fields that its version lacks. Null: all defaults.
template <class Sized>
[[nodiscard]] Result<Sized> taken(const char* name, const Sized* from, Sized defaults) {
    if (from == nullptr) return defaults;
    if (auto valid = check_size<Sized>(name, from->struct_size); !valid) return valid.error();
    std::memcpy(&defaults, from, from->struct_size);
    return defaults;
}

}  // namespace weft::c
