#pragma once
// All hinges of a cloth as dihedral bending elements, and the corners that each particle gathers from.

#include <array>
#include <cstdint>
#include <functional>
#include <span>

#include "cloth/mesh/rest/rest_elements.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/memory/shared_buffer.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// Input of HingeElements::compute().
struct HingePass {
    float rigidity;  ///< [N m]
    std::span<const Vec4> positions;
    std::span<const Vec4> velocities;  ///< empty: no viscous moment
    float viscosity;                   ///< of the viscous moment [s]
};

class HingeElements {
  public:
    /// One corner of a hinge, listed at its particle, with the entries of the particle's row for the hinge's
    /// three other corners in cyclic order.
    struct Corner {
        std::uint32_t hinge, corner;
        std::array<std::uint32_t, 3> entries;
    };
    /// entry_of(i, j) is where block (i, j) is stored.
    HingeElements(const Bending& bending, std::uint32_t particles,
                  const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& entry_of);

    void compute(Parallel& parallel, const HingePass& pass);

    [[nodiscard]] std::span<const Corner> corners(std::uint32_t particle) const noexcept {
        const std::uint32_t begin = corner_offsets_[particle];
        return corners_.span().subspan(begin, corner_offsets_[particle + 1] - begin);
    }
    [[nodiscard]] Vector3 gradient(std::uint32_t hinge, std::uint32_t corner) const noexcept {
        return xyz(results_[4 * std::size_t{hinge} + corner]);
    }
    /// The moment of a hinge: the force on a corner is the moment times the gradient [N m].
    [[nodiscard]] float moment(std::uint32_t hinge) const noexcept {
        return results_[4 * std::size_t{hinge}].w;
    }
    /// The factor of g g^T, for the gradient g of the angle, in the Hessian [N m]. Second derivatives of
    /// angles are left out (Gauss and Newton). The coupling of two hinges is added to both, which bounds it
    /// from above: 2 phi_e phi_f <= phi_e^2 + phi_f^2.
    [[nodiscard]] float stiffness(std::uint32_t hinge) const noexcept {
        return results_[4 * std::size_t{hinge} + 1].w;
    }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return hinges_.bytes() + partner_offsets_.bytes() + partners_.bytes() + bends_.bytes() +
               results_.bytes() + corner_offsets_.bytes() + corners_.bytes();
    }

  private:
    /// Another hinge that bends this one, through the triangle that they share.
    struct Partner {
        std::uint32_t hinge;
        float weight;  ///< w_ef times both lengths
    };
    void store_corners(std::span<const Hinge> hinges,
                       const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& entry_of);
    void store_partners(const Bending& bending);
    void bend(const HingePass& pass, std::uint32_t hinge);
    void sum_moments(float rigidity, std::uint32_t hinge);

    SharedBuffer<Hinge> hinges_;
    SharedBuffer<std::uint32_t> partner_offsets_;
    SharedBuffer<Partner> partners_;
    AlignedBuffer<float> bends_;   // angles less those at rest, viscous parts added
    AlignedBuffer<Vec4> results_;  // per hinge its gradient, with moment and stiffness in w
    SharedBuffer<std::uint32_t> corner_offsets_;
    SharedBuffer<Corner> corners_;  // by particle, hinges ascending
};

}  // namespace weft
