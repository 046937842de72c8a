#pragma once
// What the sides of a triangle do to one another, on general meshes: the part of the membrane that springs by
// themselves cannot have. See membrane.h.

#include <cstdint>
#include <span>

#include "cloth/mesh/cook.h"
#include "cloth/system/springs/spring_table.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/memory/shared_buffer.h"
#include "engine/threads/parallel_blocks.h"
#include "engine/vector.h"

namespace weft {

/// Triangles in groups of 16 lanes; those behind the last are of one particle and have no part in anything.
class MembraneCoupling {
  public:
    static constexpr std::uint32_t lanes = Stencil::lanes;

    /// None, as on sheets.
    MembraneCoupling() = default;
    MembraneCoupling(const ClothModel& model, const SpringMatrix& matrix, bool stiffens = false);
    /// visit(list) and visit.value(number) for all that is constant.
    template <class Self, class Visit>
    static void for_each_list(Self& self, Visit& visit) {
        visit.value(self.stiffest_extra_);
        visit(self.corners_);
        visit(self.rest_lengths_);
        visit(self.factors_);
        visit(self.sources_);
        visit(self.stiffness_);
        visit(self.stiffening_);
        visit(self.ahead_);
    }
    /// Whether lists that were read name only what there is.
    [[nodiscard]] bool is_sound(const ClothModel& model, std::size_t entries, bool stiffens) const;
    /// After lists were read: what follows from them, and what changes, without memory.
    void complete(const ClothModel& model, Unmade later);
    /// Gives one that is a copy memory of its own for other fabrics. May run out of memory.
    void make_own();
    /// For the fabric that the table has. Precondition: make_own().
    void set(const ClothModel& model, const SpringMatrix& matrix, const SpringTable& table) noexcept;

    [[nodiscard]] bool empty() const noexcept { return groups_ == 0; }
    /// Works out what force each side has more where particles at `positions` move by x: n_k sum_m S_km n_m .
    /// (difference of x over side m), S being TriangleMembrane::shared. Returns x . (S x) [N m].
    double stiffen(Parallel& parallel, std::span<const Vec4> positions, std::span<const Vec4> x);
    /// row += scale times (S x)_i of the last stiffen().
    void add_forces(std::uint32_t particle, float scale, Vec4& row) const noexcept {
        Vector3 sum = Vector3::Zero();
        for (std::uint32_t c = corner_offsets_[particle]; c < corner_offsets_[particle + 1]; ++c)
            sum += xyz(forces_[behind(ahead_[c])]) - xyz(forces_[ahead_[c]]);
        row = to_vec4(xyz(row) + scale * sum, 0);
    }

    /// By how much springs' rest lengths are shifted where particles are at `positions`.
    void compute(Parallel& parallel, std::span<const Vec4> positions);
    /// [m] of each side of each triangle, and last a 0.
    [[nodiscard]] const float* shifts() const noexcept { return shifts_.data(); }
    /// Of each entry the two sides that shift it, [slot * 2 + 0 or 1] * 16 + lane.
    [[nodiscard]] const std::uint32_t* sources() const noexcept { return sources_.data(); }

    /// What stiffening adds at those positions to the tension [N] and the stiffness [N/m] of each side's
    /// spring, as shifts(); null: nothing.
    [[nodiscard]] const float* extra_tensions() const noexcept { return extra_tensions_.data(); }
    [[nodiscard]] const float* extra_stiffness() const noexcept { return extra_stiffness_.data(); }
    /// The most that it adds to a spring, however stretched [N/m].
    [[nodiscard]] float stiffest_extra() const noexcept { return stiffest_extra_; }

    [[nodiscard]] std::size_t bytes() const noexcept {
        return corners_.bytes() + rest_lengths_.bytes() + factors_.bytes() + sources_.bytes() +
               shifts_.bytes() + stiffness_.bytes() + forces_.bytes() + partials_.bytes() + ahead_.bytes() +
               stiffening_.bytes() + extra_tensions_.bytes() + extra_stiffness_.bytes();
    }

  private:
    /// The place of the side that ends where the side at that place begins.
    [[nodiscard]] static std::uint32_t behind(std::uint32_t ahead) noexcept {
        return ahead / lanes % 3 == 0 ? ahead + 2 * lanes : ahead - lanes;
    }
    [[nodiscard]] std::uint32_t place(std::uint32_t triangle, std::uint32_t side) const noexcept {
        return (triangle / lanes * 3 + side) * lanes + triangle % lanes;
    }

    [[nodiscard]] static std::uint32_t groups_of(const ClothModel& model) {
        return (static_cast<std::uint32_t>(model.triangles.size()) + lanes - 1) / lanes;
    }
    void set_stiffening(const ClothModel& model, std::uint32_t triangle, const Fabric& fabric) noexcept;

    std::uint32_t groups_ = 0;
    SharedBuffer<std::uint32_t> corners_;  // [(group * 3 + corner) * 16 + lane]
    SharedBuffer<float> rest_lengths_;     // of sides, likewise
    SharedBuffer<float> factors_;          // [(group * 9 + 3 * side + by) * 16 + lane]: shift per extension
    SharedBuffer<std::uint32_t> sources_;
    AlignedBuffer<float> shifts_;
    SharedBuffer<float> stiffness_;  // of each side's spring [N/m]
    // Of triangles that stiffen: [(group * 8 + k) * 16 + lane], strains by sides along warp and along weft,
    // then both moduli.
    SharedBuffer<float> stiffening_;
    AlignedBuffer<float> extra_tensions_, extra_stiffness_;
    float stiffest_extra_ = 0;
    AlignedBuffer<Vec4> forces_;  // of each side, along it from its first corner
    AlignedBuffer<double> partials_;
    std::span<const std::uint32_t> corner_offsets_;  // the model's
    SharedBuffer<std::uint32_t> ahead_;              // of particles: the sides that begin at them
};

}  // namespace weft
