#pragma once
// The springs of a general mesh, by rings: see RingOrder. With a triangle's three sides at hand where its
// particle looks at two of them, what the sides do to one another costs a few products; see membrane.h.

#include <cstdint>
#include <span>

#include "cloth/mesh/cook.h"
#include "cloth/system/springs/ring_order.h"
#include "cloth/system/springs/spring_matrix.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/memory/shared_buffer.h"
#include "weft/settings.h"

namespace weft {

/// In groups of 16 particles, as the matrix. A group has places: the first is the opening, the triangle
/// between a ring's last and first neighbour; then one for each of its slots with springs. Lanes that do not
/// need a place have 0 there.
class Rings {
  public:
    static constexpr std::uint32_t lanes = Stencil::lanes;

    /// What a place holds [(place * count + k) * 16 + lane]. Its triangle lies between its neighbour, whose
    /// side is `a`, and the next one, whose side is `b`; the third side is that between these two. The
    /// tension of a spring is `slope` times its length, less `at_zero`; and for each of its triangles `other`
    /// times the other side at the particle, and `third_a` or `third_b` times the third side.
    enum Number : std::uint32_t {
        stiffness,  ///< the part of the slope that the matrix knows [N/m]
        slope,      ///< [N/m]
        at_zero,    ///< [N]
        other,      ///< [N/m]
        third_a,    ///< [N/m]
        third_b,    ///< [N/m]
        count
    };
    /// Of a place whose triangle stiffens, for warp and then for weft: strain by the length of each side
    /// [1/m] and at a length of 0, and the modulus, see TriangleStiffening. Then for sheets q times the rest
    /// length [N], see spring_at(), and 1 / rest length [1/m].
    enum Stiffening : std::uint32_t {
        by_a,
        by_b,
        by_third,
        strain_at_zero,
        modulus,
        axis_count,
        of_sheet = 2 * axis_count,
        per_rest_length,
        stiffening_count
    };
    /// Of each place, from the last linearisation on, in halves: the unit directions of its neighbour and of
    /// its third side; and how far warp and weft had come on their way to the end of stiffening, by a and b.
    static constexpr std::uint32_t directions_count = 6, reached_count = 4;

    Rings() = default;
    /// `stiffens`: for fabrics that do, and others.
    Rings(const ClothModel& model, const RingOrder& order, const SpringMatrix& matrix, bool stiffens);
    /// visit(list) and visit.value(number) for all that is constant.
    template <class Self, class Visit>
    static void for_each_list(Self& self, Visit& visit) {
        visit.value(self.stiffest_);
        visit.value(self.stiffest_bending_);
        visit(self.springs_);
        visit(self.stiffening_);
        visit(self.bending_);
        visit(self.last_);
        visit(self.closes_);
        visit(self.corners_);
    }
    /// Whether lists that were read fit so many places and entries, and name only what there is.
    [[nodiscard]] bool is_sound(const ClothModel& model, std::size_t places, std::size_t entries,
                                bool stiffens) const;
    /// After lists were read: gives what changes its size, without memory.
    void complete(Unmade later);
    /// Gives one that is a copy memory of its own for other fabrics. May run out of memory.
    void make_own();
    /// Takes O(springs). Precondition: make_own().
    void set(const ClothModel& model, const SpringMatrix& matrix, const Fabric& fabric) noexcept;

    [[nodiscard]] bool empty() const noexcept { return last_.empty(); }
    [[nodiscard]] const float* springs() const noexcept { return springs_.data(); }
    [[nodiscard]] const float* stiffening() const noexcept { return stiffening_.data(); }  ///< null: none
    [[nodiscard]] const float* bending() const noexcept {
        return bending_.data();
    }  ///< [entry], B = 1 [1/m^2]
    /// The last neighbour in each particle's ring; the particle itself where the ring is open.
    [[nodiscard]] const std::uint32_t* last() const noexcept { return last_.data(); }
    /// Of each place a bit for each lane: set where a closed ring ends.
    [[nodiscard]] const std::uint16_t* closes() const noexcept { return closes_.data(); }
    [[nodiscard]] const std::uint16_t* directions() const noexcept { return directions_.data(); }
    [[nodiscard]] std::uint16_t* directions() noexcept { return directions_.data(); }
    [[nodiscard]] const std::uint16_t* reached() const noexcept { return reached_.data(); }
    [[nodiscard]] std::uint16_t* reached() noexcept { return reached_.data(); }

    [[nodiscard]] float stiffest() const noexcept { return stiffest_; }  ///< however stretched [N/m]
    [[nodiscard]] float stiffest_bending() const noexcept { return stiffest_bending_; }  ///< B = 1 [1/m^2]
    [[nodiscard]] std::size_t bytes() const noexcept {
        return springs_.bytes() + stiffening_.bytes() + bending_.bytes() + last_.bytes() + closes_.bytes() +
               corners_.bytes() + directions_.bytes() + reached_.bytes();
    }

  private:
    [[nodiscard]] float& number(std::uint32_t entry, Number k) noexcept {
        return springs_[lane_index(entry, k, count)];
    }
    [[nodiscard]] float& number(std::uint32_t entry, std::uint32_t k) noexcept {
        return stiffening_[lane_index(entry, k, stiffening_count)];
    }
    void set_triangles(const ClothModel& model, const SpringMatrix& matrix, const Fabric& fabric) noexcept;
    void set_cells(const ClothModel& model, const SpringMatrix& matrix, const Fabric& fabric) noexcept;
    /// Returns the most that it adds to the stiffness of a side [N/m].
    float set_stiffening(const ClothModel& model, std::uint32_t triangle, const Fabric& fabric) noexcept;

    SharedBuffer<float> springs_, stiffening_, bending_;
    SharedBuffer<std::uint32_t> last_;
    SharedBuffer<std::uint16_t> closes_;
    /// Of each triangle's corners the place * 16 + lane where it is, times 2; and 1 more where the side to
    /// the triangle's next corner is b.
    SharedBuffer<std::uint32_t> corners_;
    AlignedBuffer<std::uint16_t> directions_, reached_;
    float stiffest_ = 0, stiffest_bending_ = 0;
};

}  // namespace weft
