#pragma once
// A fingerprint of simulation state: equal bytes, equal hash.

#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>

namespace weft {

/// Streaming XXH3, 64 bits (Collet; https://xxhash.com), of everything added, in the order added.
class StateHash {
  public:
    StateHash();
    ~StateHash();
    StateHash(const StateHash&) = delete;
    StateHash& operator=(const StateHash&) = delete;

    template <class T>
    requires std::is_trivially_copyable_v<T>
    void add(std::span<const T> values) { add_bytes(std::as_bytes(values)); }
    [[nodiscard]] std::uint64_t value() const noexcept;

  private:
    void add_bytes(std::span<const std::byte> bytes) noexcept;
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace weft
