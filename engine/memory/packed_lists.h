#pragma once
// Lists and values packed in bytes, one behind the other, each laid out as in an AlignedBuffer: at a multiple
// of 64 bytes, and padded with T{} to whole groups of 16. So a list can be used in place.
//
// The classes are visitors: an object that passes its parts in one order to each is counted, written or read.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

#include "engine/memory/shared_buffer.h"

namespace weft {

/// Number of bytes, rounded up to the alignment.
constexpr std::size_t packed_size(std::size_t bytes) {
    return (bytes + memory_alignment - 1) / memory_alignment * memory_alignment;
}

/// Type of a list's items as they are packed.
template <class List>
using PackedItem = std::remove_cvref_t<decltype(std::declval<List&>()[0])>;
template <class T>
constexpr std::size_t packed_list_size(std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    return packed_size(AlignedBuffer<T>::padded(count) * sizeof(T));
}

class PackedSize {
  public:
    template <class List>
    void operator()(const List& list) {
        bytes_ += packed_size(sizeof(std::uint64_t)) + packed_list_size<PackedItem<const List>>(list.size());
    }
    template <class T>
    void value(const T& /*value*/) {
        bytes_ += packed_size(sizeof(T));
    }
    [[nodiscard]] std::size_t bytes() const noexcept { return bytes_; }

  private:
    std::size_t bytes_ = 0;
};

class PackedWriter {
  public:
    /// Precondition: as many bytes as PackedSize has counted.
    explicit PackedWriter(std::span<std::byte> to) : left_(to) {}

    template <class List>
    void operator()(const List& list) {
        using Item = PackedItem<const List>;
        value(std::uint64_t{list.size()});
        put(list.data(), list.size() * sizeof(Item), packed_list_size<Item>(list.size()));
    }
    template <class T>
    void value(const T& value) {
        static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>);
        put(&value, sizeof value, packed_size(sizeof value));
    }

  private:
    void put(const void* from, std::size_t bytes, std::size_t whole) {
        if (bytes > 0) std::memcpy(left_.data(), from, bytes);
        std::ranges::fill(left_.subspan(bytes, whole - bytes), std::byte{});
        left_ = left_.subspan(whole);
    }

    std::span<std::byte> left_;
};

/// Lends SharedBuffers the memory that it reads, and copies other lists. Values are not checked, but padding
/// has to be zero.
class PackedReader {
  public:
    /// Precondition: the bytes begin at a multiple of 64, and the owner keeps them.
    PackedReader(std::span<const std::byte> bytes, std::shared_ptr<const void> owner)
        : left_(bytes), owner_(std::move(owner)) {}

    template <class T>
    void operator()(SharedBuffer<T>& list) {
        list = SharedBuffer<T>::lent(owner_, take_list<T>());
    }
    template <class List>
    void operator()(List& list) {
        const auto items = take_list<PackedItem<List>>();
        list.assign(items.begin(), items.end());
    }
    template <class T>
    void value(T& value) {
        if (const auto bytes = take(sizeof value, packed_size(sizeof value)); !bytes.empty())
            std::memcpy(&value, bytes.data(), sizeof value);
    }
    /// Whether all bytes were needed, and no more.
    [[nodiscard]] bool fits() const { return is_sound_ && left_.empty(); }
    /// Whether all parts so far were there, with zeros as padding.
    [[nodiscard]] bool is_sound() const { return is_sound_; }

  private:
    template <class T>
    std::span<const T> take_list() {
        std::uint64_t count = 0;
        value(count);
        is_sound_ = is_sound_ && count <= left_.size() / sizeof(T);
        if (!is_sound_ || count == 0) return {};
        const auto items = static_cast<std::size_t>(count);
        const auto bytes = take(items * sizeof(T), packed_list_size<T>(items));
        return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
    }
    std::span<const std::byte> take(std::size_t bytes, std::size_t whole) {
        is_sound_ = is_sound_ && whole <= left_.size();
        if (!is_sound_) return {};
        const auto taken = left_.first(bytes), filling = left_.subspan(bytes, whole - bytes);
        left_ = left_.subspan(whole);
        is_sound_ = std::ranges::all_of(filling, [](std::byte b) { return b == std::byte{}; });
        return taken;
    }

    std::span<const std::byte> left_;
    std::shared_ptr<const void> owner_;
    bool is_sound_ = true;
};

}  // namespace weft
