#pragma once
// Objects named by generation-checked ids: an id outlives its object without ever reaching another one.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace weft {

/// First generation of a map: another number at each call in this process, never 0. Any n consecutive ones, n
/// up to 2^15, lie at least 2^32 / (3 n) apart: they are the multiples of the golden ratio.
[[nodiscard]] inline std::uint32_t new_first_generation() noexcept {
    static std::atomic<std::uint32_t> calls = 0;
    constexpr std::uint32_t golden_ratio = 0x9E3779B9u;  // its fraction times 2^32 (Knuth 1973, section 6.4)
    std::uint32_t first = 0;
    while (first == 0) first = golden_ratio * ++calls;
    return first;
}

/// `Id` is an aggregate {index, generation} of unsigned numbers; all-zero is null, so no generation is 0.
/// Iteration visits live objects in index order. insert() may move the objects; ids stay, pointers do not.
///
/// A slot's generations count up from `first_generation`, with 1 after the largest, until all are used up.
/// Two maps refuse each other's ids until a slot has been reused as often as their first generations lie
/// apart.
template <class Id, class T>
class SlotMap {
  public:
    using Generation = decltype(Id::generation);

    /// Precondition: first_generation is not 0.
    explicit SlotMap(Generation first_generation = 1) : first_generation_(first_generation) {}

    Id insert(const T& value) { return insert(T(value)); }
    /// If it throws, the value is unchanged.
    Id insert(T&& value) {
        if (free_.empty()) {
            if (free_.capacity() <= slots_.size())
                free_.reserve(2 * slots_.size() + 1);  // so that erase never allocates
            slots_.push_back({first_generation_, std::nullopt});
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
        // A slot whose generations are used up is never handed out again: its first id would become valid
        // again.
        if (++slot.generation == 0) slot.generation = 1;
        if (slot.generation != first_generation_)
            free_.push_back(id.index);
        else
            ++retired_;
        return true;
    }

    [[nodiscard]] std::size_t size() const noexcept { return slots_.size() - free_.size() - retired_; }

    /// Number of slots; all ids have lower indices.
    [[nodiscard]] std::size_t slots() const noexcept { return slots_.size(); }

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
        Generation generation;
        std::optional<T> value;
    };

    [[nodiscard]] bool holds(Id id) const noexcept {
        return id.index < slots_.size() && slots_[id.index].value &&
               slots_[id.index].generation == id.generation;
    }

    Generation first_generation_;
    std::vector<Slot> slots_;
    std::vector<std::uint32_t> free_;
    std::size_t retired_ = 0;
};

}  // namespace weft
