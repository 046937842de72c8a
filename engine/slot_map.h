#pragma once
// Objects named by generation-checked ids: an id outlives its object without ever reaching another one.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace weft {

/// `Id` is an aggregate {std::uint32_t index, generation}; all-zero is null, so generations start at 1.
/// Iteration visits live objects in index order.
template <class Id, class T>
class SlotMap {
  public:
    Id insert(T value);
    /// Null if the id is null, stale or out of range.
    [[nodiscard]] T* find(Id id) noexcept;
    [[nodiscard]] const T* find(Id id) const noexcept;
    /// False if the id is null, stale or out of range.
    bool erase(Id id) noexcept;
    [[nodiscard]] std::size_t size() const noexcept;

    template <class F>
    void for_each(F&& f);  // f(Id, T&)
};

}  // namespace weft
