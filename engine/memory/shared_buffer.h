#pragma once
// Memory that is written while an object is made and only read afterwards: copies share it. A copy that is to
// change needs memory of its own first.

#include <cstddef>
#include <memory>
#include <span>
#include <utility>

#include "engine/memory/aligned_buffer.h"

namespace weft {

/// An AlignedBuffer that copies share, padded as that is. A buffer with copies must not change any more, nor
/// may a copy change before make_own(). So threads may copy one buffer at the same time, and read all copies.
/// A lent buffer refers to memory that another owner keeps, such as a file's, and is only read.
template <class T>
class SharedBuffer {
  public:
    SharedBuffer() = default;
    /// `size` elements, all of value T{}. Throws std::bad_alloc, as everything here that allocates.
    explicit SharedBuffer(std::size_t size) : SharedBuffer(AlignedBuffer<T>(size)) {}
    SharedBuffer(AlignedBuffer<T>&& made) : size_(made.size()) {  // NOLINT(google-explicit-constructor)
        if (size_ == 0) return;
        const auto memory = std::make_shared<AlignedBuffer<T>>(std::move(made));
        data_ = memory->data();
        memory_ = memory;
    }
    explicit SharedBuffer(std::span<const T> values)
        : SharedBuffer(AlignedBuffer<T>::from_bytes(std::as_bytes(values))) {}
    /// A buffer of values that `owner` keeps unchanged, aligned and padded as an AlignedBuffer's.
    [[nodiscard]] static SharedBuffer lent(std::shared_ptr<const void> owner, std::span<const T> values) {
        SharedBuffer made;
        if (values.empty()) return made;
        made.memory_ = std::move(owner);
        made.data_ = const_cast<T*>(values.data());
        made.size_ = values.size();
        made.is_lent_ = true;
        return made;
    }

    SharedBuffer(SharedBuffer&& other) noexcept { *this = std::move(other); }
    SharedBuffer& operator=(SharedBuffer&& other) noexcept {
        memory_ = std::move(other.memory_);
        data_ = std::exchange(other.data_, nullptr);
        size_ = std::exchange(other.size_, 0);
        is_copy_ = std::exchange(other.is_copy_, false);
        is_lent_ = std::exchange(other.is_lent_, false);
        return *this;
    }
    SharedBuffer(const SharedBuffer& other) noexcept
        : memory_(other.memory_), data_(other.data_), size_(other.size_), is_copy_(other.size_ > 0) {}
    SharedBuffer& operator=(const SharedBuffer& other) noexcept {
        if (this != &other) *this = SharedBuffer(other);
        return *this;
    }
    ~SharedBuffer() = default;

    /// Gives a copy or a lent buffer memory of its own, with the same values.
    void make_own() {
        if (is_copy_ || is_lent_) *this = SharedBuffer(std::as_const(*this).span());
    }

    [[nodiscard]] T* data() noexcept { return data_; }
    [[nodiscard]] const T* data() const noexcept { return data_; }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    /// Bytes of its memory; 0 for a copy, whose original counts them. Lent memory counts.
    [[nodiscard]] std::size_t bytes() const noexcept {
        return is_copy_ ? 0 : AlignedBuffer<T>::padded(size_) * sizeof(T);
    }
    T& operator[](std::size_t i) noexcept { return data_[i]; }
    const T& operator[](std::size_t i) const noexcept { return data_[i]; }
    [[nodiscard]] std::span<T> span() noexcept { return {data_, size_}; }
    [[nodiscard]] std::span<const T> span() const noexcept { return {data_, size_}; }
    [[nodiscard]] T* begin() noexcept { return data_; }
    [[nodiscard]] T* end() noexcept { return data_ + size_; }
    [[nodiscard]] const T* begin() const noexcept { return data_; }
    [[nodiscard]] const T* end() const noexcept { return data_ + size_; }

  private:
    std::shared_ptr<const void> memory_;
    T* data_ = nullptr;
    std::size_t size_ = 0;
    bool is_copy_ = false, is_lent_ = false;
};

}  // namespace weft
