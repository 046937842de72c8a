#pragma once
// SpringTable holds the springs and the bending at each entry of a grid's matrix, for one fabric.

#include <cstdint>

#include "cloth/fabric/springs/spring_matrix.h"
#include "cloth/mesh/cook.h"
#include "engine/memory/shared_buffer.h"
#include "weft/settings.h"

namespace weft {

/// Calls body(half-edge, entry) for the half-edges that have an entry: those to later particles.
template <class Body>
void for_each_entry(const ClothModel& model, const SpringMatrix& matrix, const Body& body) {
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            const std::uint32_t j = model.neighbours[e];
            if (j > i) body(e, matrix.diagonals.entry_between(i, j));
        }
    }
}

/// Numbers are stored per entry: those of bending for all diagonals, those of springs for the diagonals that
/// have any.
class SpringTable {
  public:
    SpringTable() = default;
    /// With `stiffens`, the table serves fabrics that stiffen as well as others.
    SpringTable(const ClothModel& model, const SpringMatrix& matrix, bool stiffens = false);
    /// Gives a copy its own memory for another fabric's membrane. May run out of memory.
    void make_own();
    /// Computes the springs of a fabric, in O(springs). Precondition: make_own().
    void set(const ClothModel& model, const SpringMatrix& matrix, const Fabric& fabric) noexcept;
    [[nodiscard]] bool empty() const noexcept { return bending_.empty(); }

    /// By the place of a spring, see SpringMatrix::spring_place().
    [[nodiscard]] const float* rest_lengths() const noexcept { return rest_lengths_.data(); }
    [[nodiscard]] const float* stiffness() const noexcept { return stiffness_.data(); }
    /// q [N/m], see spring_at(); null: the springs do not stiffen.
    [[nodiscard]] const float* stiffening() const noexcept { return stiffening_.data(); }
    /// Each entry's bending stiffness between its two ends, for a rigidity of 1 [1/m^2].
    [[nodiscard]] const float* bending() const noexcept { return bending_.data(); }

    [[nodiscard]] float stiffest() const noexcept { return stiffest_; }  ///< at any stretch [N/m]
    [[nodiscard]] float stiffest_bending() const noexcept { return stiffest_bending_; }  ///< B = 1 [1/m^2]
    /// Calls visit(list) and visit.value(number) for all lists and numbers.
    template <class Self, class Visit>
    static void for_each_list(Self& self, Visit& visit) {
        visit.value(self.stiffest_);
        visit.value(self.stiffest_bending_);
        visit(self.rest_lengths_);
        visit(self.stiffness_);
        visit(self.bending_);
        visit(self.stiffening_);
    }
    /// Whether lists that were read have the sizes for so many entries, and for so many places of springs.
    [[nodiscard]] bool is_sound(std::size_t entries, std::size_t springs, bool stiffens) const;

    [[nodiscard]] std::size_t bytes() const noexcept {
        return rest_lengths_.bytes() + stiffness_.bytes() + bending_.bytes() + stiffening_.bytes();
    }

  private:
    void set_stiffening(const ClothModel& model, const SpringMatrix& matrix, const Fabric& fabric) noexcept;

    SharedBuffer<float> rest_lengths_, stiffness_, bending_, stiffening_;
    float stiffest_ = 0, stiffest_bending_ = 0;
};

}  // namespace weft
