#pragma once
// Objects named by generation-checked ids: an id outlives its object without ever reaching another one.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace weft {

/// `Id` is an aggregate {std::uint32_t index, generation}; all-zero is null, so generations start at 1.
/// Iteration visits live objects in index order. insert() may move the objects; ids stay, pointers do not.
template <class Id, class T>
class SlotMap {
  public:
    Id insert(T value) {
        if (free_.empty()) {
            free_.reserve(slots_.size() + 1);  // so that erase never allocates
            slots_.emplace_back();
            free_.push_back(static_cast<std::uint32_t>(slots_.size() - 1));
        }
        const std::uint32_t index = free_.back();
        slots_[index].value.emplace(std::move(value));
        free_.pop_back();
        return Id{index, slots_[index].generation};
    }

    /// Null if the id is null, stale or out of range.
    [[nodiscard]] T* find(Id id) noexcept { return holds(id) ? &*slots_[id.index].value : nullptr; }
    [[nodiscard]] const T* find(Id id) const noexcept {
        return holds(id) ? &*slots_[id.index].value : nullptr;
    }

    /// False if the id is null, stale or out of range.
    bool erase(Id id) noexcept {
        if (!holds(id)) return false;
        Slot& slot = slots_[id.index];
        slot.value.reset();
        // A slot whose generations are used up is never handed out again: its first id would come back to
        // life.
        if (++slot.generation != 0)
            free_.push_back(id.index);
        else
            ++retired_;
        return true;
    }

    [[nodiscard]] std::size_t size() const noexcept { return slots_.size() - free_.size() - retired_; }

    template <class F>
    void for_each(F&& f) {  // f(Id, T&)
        for (std::uint32_t i = 0; i < slots_.size(); ++i)
            if (slots_[i].value) f(Id{i, slots_[i].generation}, *slots_[i].value);
    }
    template <class F>
    void for_each(F&& f) const {  // f(Id, const T&)
        for (std::uint32_t i = 0; i < slots_.size(); ++i)
            if (slots_[i].value) f(Id{i, slots_[i].generation}, *slots_[i].value);
    }

  private:
    struct Slot {
        std::uint32_t generation = 1;
        std::optional<T> value;
    };

    [[nodiscard]] bool holds(Id id) const noexcept {
        return id.index < slots_.size() && slots_[id.index].value &&
               slots_[id.index].generation == id.generation;
    }

    std::vector<Slot> slots_;
    std::vector<std::uint32_t> free_;
    std::size_t retired_ = 0;
};

}  // namespace weft
