#pragma once
// A fingerprint of simulation state: equal bytes, equal hash.

#include <cstdint>
#include <memory>
#include <ranges>
#include <span>
#include <type_traits>

namespace weft {

/// Streaming XXH3, 64 bits (Collet 2019; https://xxhash.com), of everything added, in the order added, and of
/// how many values of which size each call added: a value that moves from the end of one array to the start
/// of the next changes the hash.
class StateHash {
  public:
    StateHash();
    ~StateHash();
    StateHash(const StateHash&) = delete;
    StateHash& operator=(const StateHash&) = delete;

    /// Precondition: T has no padding and no pointers, whose bytes are not state.
    template <class T, std::size_t extent>
    requires std::is_trivially_copyable_v<T>
    void add(std::span<T, extent> values) noexcept {
        const std::uint64_t shape[] = {values.size(), sizeof(T)};
        add_bytes(std::as_bytes(std::span(shape)));
        add_bytes(std::as_bytes(values));
    }
    /// Adds one value, as a span of it.
    template <class T>
    requires std::is_trivially_copyable_v<T> &&
        (!std::is_pointer_v<T>)&&(!std::ranges::range<T>)void add(const T& value) noexcept {
        add(std::span(&value, 1));
    }
    [[nodiscard]] std::uint64_t value() const noexcept;
    /// Restores the initial state.
    void reset() noexcept;

  private:
    void add_bytes(std::span<const std::byte> bytes) noexcept;
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace weft
