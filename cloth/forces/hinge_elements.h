#pragma once
// All hinges of a cloth as dihedral bending elements, and which particles gather what of them.

#include <array>
#include <cstdint>
#include <functional>
#include <span>

#include "cloth/forces/rest_elements.h"
#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"

namespace weft {

/// What is asked of the hinges.
struct HingePass {
    float rigidity;  ///< [N m]
    std::span<const Vec4> positions;
    std::span<const Vec4> velocities;  ///< empty: no viscous moment
    float viscosity;                   ///< of the viscous moment [s]
};

class HingeElements {
  public:
    /// A corner of a hinge at a particle, and the entries of its row for the hinge's next three corners,
    /// cyclically.
    struct Corner {
        std::uint32_t hinge, corner;
        std::array<std::uint32_t, 3> entries;
    };
    /// entry_of(i, j) is where block (i, j) is stored.
    HingeElements(std::span<const Hinge> hinges, std::uint32_t particles,
                  const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& entry_of);

    void compute(Parallel& parallel, const HingePass& pass);

    [[nodiscard]] std::span<const Corner> corners(std::uint32_t particle) const noexcept {
        const std::uint32_t begin = corner_offsets_[particle];
        return corners_.span().subspan(begin, corner_offsets_[particle + 1] - begin);
    }
    [[nodiscard]] Vector3 gradient(std::uint32_t hinge, std::uint32_t corner) const noexcept {
        return xyz(results_[4 * std::size_t{hinge} + corner]);
    }
    /// Of the force along the gradient [N m].
    [[nodiscard]] float moment(std::uint32_t hinge) const noexcept {
        return results_[4 * std::size_t{hinge}].w;
    }
    /// The Hessian, after Gauss and Newton, is this times the gradients' products [N m].
    [[nodiscard]] float stiffness(std::uint32_t hinge) const noexcept {
        return results_[4 * std::size_t{hinge} + 1].w;
    }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return hinges_.bytes() + results_.bytes() + corner_offsets_.bytes() + corners_.bytes();
    }

  private:
    AlignedBuffer<Hinge> hinges_;
    AlignedBuffer<Vec4> results_;  // per hinge its gradient, with moment and stiffness in w
    AlignedBuffer<std::uint32_t> corner_offsets_;
    AlignedBuffer<Corner> corners_;  // by particle, hinges ascending
};

}  // namespace weft
