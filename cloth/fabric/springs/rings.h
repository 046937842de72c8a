#pragma once
// Rings store the springs of a general mesh in the order of RingOrder. A kernel that goes round a particle
// then has all three sides of each triangle in registers, so the coupling of the sides (see membrane.h) costs
// a few products.

#include <cstdint>
#include <span>

#include "cloth/fabric/springs/membrane.h"
#include "cloth/fabric/springs/ring_order.h"
#include "cloth/fabric/springs/spring_matrix.h"
#include "cloth/mesh/cook.h"
#include "engine/memory/scratch.h"
#include "engine/memory/shared_buffer.h"
#include "weft/settings.h"

namespace weft {

/// Groups are those of the matrix: 16 particles each. The first place of a group is the opening, the triangle
/// between a ring's last and first neighbour. One place follows for each of the group's slots that has
/// springs. Lanes that do not use a place hold 0 there.
class Rings {
  public:
    static constexpr std::uint32_t lanes = Stencil::lanes;

    /// The numbers of a place, at [(place * count + k) * 16 + lane]. Its triangle lies between its neighbour,
    /// whose side is `a`, and the next one, whose side is `b`; the third side is that between these two. The
    /// tension of a spring is `slope` times its length, less `at_zero`; and for each of its triangles `other`
    /// times the other side at the particle, and `third_a` or `third_b` times the third side.
    enum Number : std::uint32_t {
        stiffness,  ///< the part of the slope that is in W [N/m]
        slope,      ///< [N/m]
        at_zero,    ///< [N]
        other,      ///< [N/m]
        third_a,    ///< [N/m]
        third_b,    ///< [N/m]
        count
    };
    /// The numbers of a place whose triangle stiffens (see TriangleStiffening): for warp and then for weft,
    /// the strain per length of each side [1/m], the strain at length 0 and the modulus. Sheets follow with q
    /// times the rest length [N] (see spring_at()) and 1 / rest length [1/m].
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
    /// The last linearisation stores these halves at each place: the unit directions to the neighbour and
    /// along the third side; and the clamped strains of warp and weft as sides a and b compute them.
    static constexpr std::uint32_t directions_count = 6, reached_count = 4;

    Rings() = default;
    /// With `stiffens`, the rings serve fabrics that stiffen as well as others.
    Rings(const ClothModel& model, const RingOrder& order, const SpringMatrix& matrix, bool stiffens);
    /// Calls visit(list) and visit.value(number) for all that is constant.
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
    /// Whether lists read from a file have the sizes for so many places and entries, and valid indices.
    [[nodiscard]] bool is_sound(const ClothModel& model, std::size_t places, std::size_t entries,
                                bool stiffens) const;
    void lay_out(Scratch& scratch);
    /// Gives a copy its own memory for the numbers of another fabric. May run out of memory.
    void make_own();
    /// Computes the numbers that depend on the fabric, in O(springs). Precondition: make_own().
    void set(const ClothModel& model, const SpringMatrix& matrix, const Fabric& fabric) noexcept;

    [[nodiscard]] bool empty() const noexcept { return last_.empty(); }
    [[nodiscard]] const float* springs() const noexcept { return springs_.data(); }
    [[nodiscard]] const float* stiffening() const noexcept { return stiffening_.data(); }  ///< null: none
    [[nodiscard]] const float* bending() const noexcept {
        return bending_.data();
    }  ///< [entry], B = 1 [1/m^2]
    /// The last neighbour in each particle's ring; the particle itself where the ring is open.
    [[nodiscard]] const std::uint32_t* last() const noexcept { return last_.data(); }
    /// A bit for each lane of each place: set where a closed ring ends.
    [[nodiscard]] const std::uint16_t* closes() const noexcept { return closes_.data(); }
    [[nodiscard]] const std::uint16_t* directions() const noexcept { return directions_.data(); }
    [[nodiscard]] std::uint16_t* directions() noexcept { return directions_.data(); }
    [[nodiscard]] const std::uint16_t* reached() const noexcept { return reached_.data(); }
    [[nodiscard]] std::uint16_t* reached() noexcept { return reached_.data(); }

    [[nodiscard]] float stiffest() const noexcept { return stiffest_; }  ///< at any stretch [N/m]
    [[nodiscard]] float stiffest_bending() const noexcept { return stiffest_bending_; }  ///< B = 1 [1/m^2]
    [[nodiscard]] std::size_t bytes() const noexcept {
        return springs_.bytes() + stiffening_.bytes() + bending_.bytes() + last_.bytes() + closes_.bytes() +
               corners_.bytes();
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
    /// Returns the greatest stiffness that stiffening adds to a side [N/m].
    float set_stiffening(const ClothModel& model, const SpringMatrix& matrix, std::uint32_t triangle,
                         const TriangleMembrane& membrane, const Fabric& fabric) noexcept;

    SharedBuffer<float> springs_, stiffening_, bending_;
    SharedBuffer<std::uint32_t> last_;
    SharedBuffer<std::uint16_t> closes_;
    /// A triangle's corner, as the ring of its particle has it.
    struct Corner {
        std::uint32_t place;  ///< place * 16 + lane
        bool starts_with_b;   ///< side b leads to the triangle's next corner
    };
    [[nodiscard]] Corner corner_of(const ClothModel& model, const SpringMatrix& matrix,
                                   std::uint32_t triangle, std::uint32_t k) const noexcept;
    /// By triangle and corner: twice the place, counted in its group; plus 1 where side b starts.
    SharedBuffer<std::uint16_t> corners_;
    ScratchArray<std::uint16_t> directions_, reached_;
    float stiffest_ = 0, stiffest_bending_ = 0;
};

}  // namespace weft
