#pragma once
// Memory for per-particle data: cache-line aligned, sized once, never grown behind the solver's back.
//
// Invariant: the buffer is padded with T{} to a whole group of 16 elements. Kernels that work on groups read
// and write the padding; nobody else does.
//
// A buffer that is made as `unmade` has a size but no memory, and must not be read or written. Each copy of
// it has memory, all of value T{}. So a buffer that only serves to be copied takes none.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

#include "engine/memory/hooks.h"
#include "engine/memory/without_exceptions.h"

namespace weft {

struct Unmade {};
inline constexpr Unmade unmade;

template <class T>
class AlignedBuffer {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 64);

  public:
    static constexpr std::size_t alignment = memory_alignment;
    static constexpr std::size_t group = 16;

    AlignedBuffer() = default;
    /// `size` elements, all of value T{}. Throws std::bad_alloc where there is no memory for them.
    explicit AlignedBuffer(std::size_t size) : data_(allocate(padded(size))), size_(size) {
        std::uninitialized_fill_n(data_, padded(size), T{});
    }
    AlignedBuffer(std::size_t size, Unmade /*later*/) : size_(padded(size) > 0 ? size : 0) {}

    /// A buffer of the elements in these bytes, which may be at any address.
    [[nodiscard]] static AlignedBuffer from_bytes(std::span<const std::byte> bytes) {
        AlignedBuffer made;
        const std::size_t size = bytes.size() / sizeof(T);
        made.data_ = allocate(padded(size));
        made.size_ = size;
        if (size > 0) std::memcpy(static_cast<void*>(made.data_), bytes.data(), size * sizeof(T));
        std::uninitialized_fill_n(made.data_ + size, padded(size) - size, T{});
        return made;
    }

    AlignedBuffer(AlignedBuffer&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
    AlignedBuffer& operator=(AlignedBuffer&& other) noexcept {
        AlignedBuffer taken(std::move(other));
        std::swap(data_, taken.data_);
        std::swap(size_, taken.size_);
        return *this;
    }

    AlignedBuffer(const AlignedBuffer& other) : data_(allocate(padded(other.size_))), size_(other.size_) {
        if (other.data_ != nullptr)
            std::uninitialized_copy_n(other.data(), padded(size_), data());
        else
            std::uninitialized_fill_n(data(), padded(size_), T{});
    }
    /// Between buffers of one size nothing is allocated and data() stays. A copy that throws changes nothing.
    AlignedBuffer& operator=(const AlignedBuffer& other) {
        if (this == &other) return *this;
        if (size_ != other.size_ || data_ == nullptr || other.data_ == nullptr)
            return *this = AlignedBuffer(other);
        std::copy_n(other.data(), padded(size_), data());
        return *this;
    }
    ~AlignedBuffer() {
        if (data_ != nullptr) give_memory_back(data_, bytes());
    }

    [[nodiscard]] T* data() noexcept { return data_; }
    [[nodiscard]] const T* data() const noexcept { return data_; }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    /// Bytes of its memory; of an unmade buffer, those of a copy.
    [[nodiscard]] std::size_t bytes() const noexcept { return padded(size_) * sizeof(T); }
    T& operator[](std::size_t i) noexcept { return data_[i]; }
    const T& operator[](std::size_t i) const noexcept { return data_[i]; }
    [[nodiscard]] std::span<T> span() noexcept { return {data(), size_}; }
    [[nodiscard]] std::span<const T> span() const noexcept { return {data(), size_}; }

    /// Number of elements, rounded up to whole groups.
    static constexpr std::size_t padded(std::size_t size) {
        if (size > most) refuse_memory();
        return (size + group - 1) / group * group;
    }

  private:
    static constexpr std::size_t most =
        std::numeric_limits<std::ptrdiff_t>::max() / sizeof(T) / group * group;  // addressable elements

    static T* allocate(std::size_t count) {
        if (count == 0) return nullptr;
        return static_cast<T*>(take_memory(count * sizeof(T)));
    }
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace weft
