#pragma once
// Memory for data of use within a substep only: arrays that are laid out one after the other, anew for each
// use.
//
// Arrays are laid out twice, by the same calls: once to measure their bytes, long before a step, and then in
// memory of that size, as often as needed and at no cost. So a step allocates nothing, and takes what was
// measured.
//
// Invariant: an array is padded to a whole group of 16 elements, as an AlignedBuffer is: with zeros, until a
// kernel that works on groups writes there. Its elements are not initialised: write each one after the layout
// before reading it.

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

#include "engine/memory/aligned_buffer.h"
#include "engine/memory/hooks.h"

namespace weft {

/// An array in memory that it does not own, and of whose lifetime it does not know.
template <class T>
class ScratchArray {
    static_assert(std::is_trivially_destructible_v<T> && alignof(T) <= memory_alignment);

  public:
    ScratchArray() = default;
    /// Precondition: memory for `size` elements, padded to whole groups. Null: the array has a size but no
    /// memory, and must not be read or written.
    ScratchArray(T* data, std::size_t size) noexcept : data_(data), size_(size) {}

    [[nodiscard]] T* data() noexcept { return data_; }
    [[nodiscard]] const T* data() const noexcept { return data_; }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    T& operator[](std::size_t i) noexcept { return data_[i]; }
    const T& operator[](std::size_t i) const noexcept { return data_[i]; }
    [[nodiscard]] std::span<T> span() noexcept { return {data_, size_}; }
    [[nodiscard]] std::span<const T> span() const noexcept { return {data_, size_}; }
    /// Makes the padding zero again, where arrays that took turns with this one have written. Precondition:
    /// the array is padded.
    void clear_padding() noexcept { std::fill(data_ + size_, data_ + AlignedBuffer<T>::padded(size_), T{}); }

  private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

class Scratch {
  public:
    /// Measures only: arrays get no memory.
    Scratch() = default;
    /// Precondition: the memory is aligned to memory_alignment, and large enough for all arrays.
    explicit Scratch(std::byte* memory) noexcept : begin_(memory) {}

    /// The array becomes the next `size` elements.
    template <class T>
    void take(ScratchArray<T>& array, std::size_t size) {
        take_padded(array, size, AlignedBuffer<T>::padded(size));
    }
    /// The same without padding, for arrays that no kernel works on.
    template <class T>
    void take_few(ScratchArray<T>& array, std::size_t size) {
        take_padded(array, size, size);
    }

    /// Both calls take arrays from the same place on: the first ones are no longer in use when the second
    /// ones come into use. The padding of either holds what the others left there.
    template <class First, class Second>
    void take_by_turns(const First& first, const Second& second) {
        const std::size_t begin = end_;
        first();
        const std::size_t end = std::exchange(end_, begin);
        second();
        end_ = std::max(end_, end);
    }

    /// Whether arrays have memory; else they are only measured.
    [[nodiscard]] bool has_memory() const noexcept { return begin_ != nullptr; }
    /// Bytes that all arrays lie in.
    [[nodiscard]] std::size_t bytes() const noexcept { return most_; }

  private:
    template <class T>
    void take_padded(ScratchArray<T>& array, std::size_t size, std::size_t padded) {
        std::byte* const at = begin_ == nullptr ? nullptr : begin_ + end_;
        const std::size_t bytes = padded * sizeof(T);
        array = {reinterpret_cast<T*>(at), size};
        end_ += (bytes + memory_alignment - 1) / memory_alignment * memory_alignment;
        most_ = std::max(most_, end_);
        if (at == nullptr) return;
#ifndef NDEBUG
        std::memset(at, 0xCD, bytes);  // exposes reads of elements that were not written
#endif
        std::memset(at + size * sizeof(T), 0, bytes - size * sizeof(T));
    }

    std::byte* begin_ = nullptr;
    std::size_t end_ = 0, most_ = 0;
};

/// Memory to lay arrays out in. The system is asked for it, but it is not touched before it is used.
class ScratchMemory {
  public:
    ScratchMemory() = default;
    /// Throws std::bad_alloc where there is none.
    explicit ScratchMemory(std::size_t bytes)
        : data_(bytes > 0 ? static_cast<std::byte*>(take_memory(bytes)) : nullptr), bytes_(bytes) {}
    ScratchMemory(ScratchMemory&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}
    ScratchMemory& operator=(ScratchMemory&& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(bytes_, other.bytes_);
        return *this;
    }
    ~ScratchMemory() {
        if (data_ != nullptr) give_memory_back(data_, bytes_);
    }

    [[nodiscard]] std::byte* data() const noexcept { return data_; }
    [[nodiscard]] std::size_t bytes() const noexcept { return bytes_; }

  private:
    std::byte* data_ = nullptr;
    std::size_t bytes_ = 0;
};

/// Scratch memory of an object that is used alone, until a caller lays it out in other memory. A copy of the
/// object has none.
class OwnScratch {
  public:
    OwnScratch() = default;
    OwnScratch(const OwnScratch& /*other*/) noexcept {}
    OwnScratch& operator=(const OwnScratch&) = delete;
    ~OwnScratch() = default;

    /// Lays the object out. Precondition: its lay_out(), which takes these sizes, begins with free().
    template <class Object, class... Sizes>
    void lay_out(Object& object, const Sizes&... sizes) {
        Scratch measured;
        object.lay_out(measured, sizes...);
        ScratchMemory memory(measured.bytes());
        Scratch scratch(memory.data());
        object.lay_out(scratch, sizes...);
        memory_ = std::move(memory);
    }
    void free() noexcept { memory_ = {}; }

  private:
    ScratchMemory memory_;
};

}  // namespace weft
