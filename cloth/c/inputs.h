#pragma once
// Items that lie in the host's memory.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "cloth/c/errors.h"

namespace weft::c {

/// The items of `input`, contiguous: in place, or copied to `room`. Errors: items at a null pointer; a stride
/// that is shorter than an item.
template <class T>
[[nodiscard]] Result<std::span<const T>> items(const char* name, const WeftInput& input,
                                               std::vector<T>& room) {
    if (input.count == 0) return std::span<const T>();
    if (input.data == nullptr) return no_items(name, input.count);
    if (input.stride != 0 && input.stride < sizeof(T)) return too_short(name, input.stride, sizeof(T));
    const bool is_dense = input.stride == 0 || input.stride == sizeof(T);
    if (is_dense && reinterpret_cast<std::uintptr_t>(input.data) % alignof(T) == 0)
        return std::span(static_cast<const T*>(input.data), input.count);
    const std::size_t stride = is_dense ? sizeof(T) : input.stride;
    room.resize(input.count);
    const auto* from = static_cast<const std::byte*>(input.data);
    for (T& item : room) {
        std::memcpy(&item, from, sizeof(T));
        from += stride;
    }
    return std::span<const T>(room);
}

/// Writes `values` to the host's memory. Error: too little room, or a stride that is shorter than an item.
template <class T>
[[nodiscard]] Result<void> write(const char* name, std::span<const T> values, const WeftStream& to) {
    if (values.empty()) return {};
    const std::size_t stride = to.stride == 0 ? sizeof(T) : to.stride;
    if (to.data == nullptr || stride < sizeof(T) || to.bytes < sizeof(T) ||
        (to.bytes - sizeof(T)) / stride < values.size() - 1)
        return no_room(name, to.bytes, to.stride, values.size(), sizeof(T));
    auto* at = static_cast<std::byte*>(to.data);
    for (const T& value : values) {
        std::memcpy(at, &value, sizeof(T));
        at += stride;
    }
    return {};
}

/// The host's indices of vertices.
[[nodiscard]] inline Result<std::span<const std::uint32_t>> indices(const uint32_t* vertices,
                                                                    std::size_t count) {
    if (vertices == nullptr && count > 0) return no_items("vertices", count);
    return std::span<const std::uint32_t>(vertices, count);
}

}  // namespace weft::c
