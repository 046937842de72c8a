#include "cloth/forces/hinge_elements.h"

#include <algorithm>
#include <vector>

#include "cloth/forces/bending.h"

namespace weft {

HingeElements::HingeElements(std::span<const Hinge> hinges, std::uint32_t particles,
                             const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& entry_of)
    : hinges_(hinges.size()),
      results_(4 * hinges.size()),
      corner_offsets_(particles + 1),
      corners_(4 * hinges.size()) {
    std::ranges::copy(hinges, hinges_.data());
    for (const Hinge& hinge : hinges)
        for (const std::uint32_t particle : hinge.particles) ++corner_offsets_[particle + 1];
    for (std::uint32_t i = 0; i < particles; ++i) corner_offsets_[i + 1] += corner_offsets_[i];

    std::vector<std::uint32_t> next(corner_offsets_.data(), corner_offsets_.data() + particles);
    for (std::uint32_t h = 0; h < hinges.size(); ++h) {
        const std::array<std::uint32_t, 4>& of = hinges[h].particles;
        for (std::uint32_t k = 0; k < 4; ++k) {
            corners_[next[of[k]]++] = {h,
                                       k,
                                       {entry_of(of[k], of[(k + 1) % 4]), entry_of(of[k], of[(k + 2) % 4]),
                                        entry_of(of[k], of[(k + 3) % 4])}};
        }
    }
}

void HingeElements::compute(Parallel& parallel, const HingePass& pass) {
    // Heights below this part of the rest triangles' count as it: a collapsed triangle has no normal to turn
    // about.
    constexpr float least_height = 0.05f;
    parallel.ranges(static_cast<std::uint32_t>(hinges_.size()), [&](const BlockRange& range) {
        for (std::uint32_t h = range.begin; h < range.end; ++h) {
            const Hinge& hinge = hinges_[h];
            std::array<Vector3, 4> x;
            for (std::size_t k = 0; k < 4; ++k) x[k] = xyz(pass.positions[hinge.particles[k]]);
            const Dihedral present = dihedral(x, least_height * hinge.area / hinge.length);
            float bend = present.angle - hinge.angle;
            if (!pass.velocities.empty())
                for (std::size_t k = 0; k < 4; ++k)
                    bend +=
                        pass.viscosity * present.gradient[k].dot(xyz(pass.velocities[hinge.particles[k]]));
            const float stiffness = pass.rigidity * dihedral_bending(hinge);
            const float w[] = {-stiffness * bend, stiffness, 0, 0};
            for (std::size_t k = 0; k < 4; ++k)
                results_[4 * std::size_t{h} + k] = to_vec4(present.gradient[k], w[k]);
        }
    });
}

}  // namespace weft
