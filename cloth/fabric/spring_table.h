#pragma once
// SpringTable holds the springs and the bending at each entry of a grid's matrix, for one fabric.

#include <cstdint>

#include "cloth/fabric/spring_matrix.h"
#include "cloth/mesh/cook.h"
#include "engine/memory/shared_buffer.h"
#include "weft/settings.h"

namespace weft {

/// body(half-edge, entry) for the half-edges that have one: those to later particles.
template <class Body>
void for_each_entry(const ClothModel& model, const SpringMatrix& matrix, const Body& body) {
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            const std::uint32_t j = model.neighbours[e];
            if (j > i) body(e, matrix.diagonals.entry_between(i, j));
        }
    }
}

/// Of one spring, and of the bending between its ends. Bending is of rigidity 1.
struct SpringEntry {
    float rest_length;  ///< [m]
    float stiffness;    ///< [N/m]
    float bending;      ///< [1/m^2]
};

/// Entry by entry; and by slots of 16 where all lanes have the same, as most of a sheet's do.
class SpringTable {
  public:
    SpringTable() = default;
    /// `stiffens`: for fabrics that do.
    SpringTable(const ClothModel& model, const SpringMatrix& matrix, bool stiffens = false);
    /// Gives a table that is a copy memory of its own for another fabric's membrane. May run out of memory.
    void make_own();
    /// Takes O(springs). Precondition: make_own().
    void set(const ClothModel& model, const SpringMatrix& matrix, const Fabric& fabric) noexcept;
    [[nodiscard]] bool empty() const noexcept { return slots_.empty(); }

    enum class SlotKind : std::uint32_t {
        mixed,         ///< look at each lane
        same,          ///< all lanes are as SlotEntry says
        same_bending,  ///< likewise, and there is no spring
        bending,       ///< no spring in any lane
    };
    struct Slot {
        SpringEntry entry;
        SlotKind kind;
    };
    [[nodiscard]] const Slot* slots() const noexcept { return slots_.data(); }
    [[nodiscard]] const float* rest_lengths() const noexcept { return rest_lengths_.data(); }
    [[nodiscard]] const float* stiffness() const noexcept { return stiffness_.data(); }
    [[nodiscard]] const float* bending() const noexcept { return bending_.data(); }
    /// q [N/m], see spring_at(); null: they do not stiffen.
    [[nodiscard]] const float* stiffening() const noexcept { return stiffening_.data(); }

    [[nodiscard]] float stiffest() const noexcept { return stiffest_; }  ///< however stretched [N/m]
    [[nodiscard]] float stiffest_bending() const noexcept { return stiffest_bending_; }  ///< of B = 1 [1/m^2]
    /// visit(list) and visit.value(number) for all that it has.
    template <class Self, class Visit>
    static void for_each_list(Self& self, Visit& visit) {
        visit.value(self.stiffest_);
        visit.value(self.stiffest_bending_);
        visit(self.rest_lengths_);
        visit(self.stiffness_);
        visit(self.bending_);
        visit(self.stiffening_);
        visit(self.slots_);
    }
    /// Whether lists that were read are of so many entries.
    [[nodiscard]] bool is_sound(std::size_t entries, bool stiffens) const;

    [[nodiscard]] std::size_t bytes() const noexcept {
        return slots_.bytes() + rest_lengths_.bytes() + stiffness_.bytes() + bending_.bytes() +
               stiffening_.bytes();
    }

  private:
    void sum_up_slots() noexcept;
    void set_stiffening(const ClothModel& model, const SpringMatrix& matrix, const Fabric& fabric) noexcept;

    SharedBuffer<float> rest_lengths_, stiffness_, bending_, stiffening_;
    SharedBuffer<Slot> slots_;
    float stiffest_ = 0, stiffest_bending_ = 0;
};

}  // namespace weft
