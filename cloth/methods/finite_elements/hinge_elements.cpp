#include "cloth/methods/finite_elements/hinge_elements.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "cloth/mesh/rest/bending.h"

namespace weft {

namespace {

/// The angle to within half a turn of 0: near a rest angle of half a turn a hinge bends to both sides,
/// although its angle jumps there by a whole turn. Precondition: |angle| is below one and a half turns.
float nearest_turn(float angle) {
    constexpr float pi = std::numbers::pi_v<float>;
    if (angle > pi) return angle - 2 * pi;
    return angle < -pi ? angle + 2 * pi : angle;
}

}  // namespace

HingeElements::HingeElements(const Bending& bending, std::uint32_t particles,
                             const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& entry_of)
    : hinges_(bending.hinges.size()),
      partner_offsets_(bending.hinges.size() + 1),
      partners_(2 * bending.pairs.size()),
      bends_(bending.hinges.size()),
      results_(4 * bending.hinges.size()),
      corner_offsets_(particles + 1),
      corners_(4 * bending.hinges.size()) {
    std::ranges::copy(bending.hinges, hinges_.data());
    store_corners(bending.hinges, entry_of);
    store_partners(bending);
}

void HingeElements::store_corners(
    std::span<const Hinge> hinges,
    const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& entry_of) {
    const std::size_t particles = corner_offsets_.size() - 1;
    for (const Hinge& hinge : hinges)
        for (const std::uint32_t particle : hinge.particles) ++corner_offsets_[particle + 1];
    for (std::size_t i = 0; i < particles; ++i) corner_offsets_[i + 1] += corner_offsets_[i];

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

void HingeElements::store_partners(const Bending& bending) {
    for (const HingePair& pair : bending.pairs) {
        ++partner_offsets_[pair.first + 1];
        ++partner_offsets_[pair.second + 1];
    }
    for (std::size_t h = 0; h < hinges_.size(); ++h) partner_offsets_[h + 1] += partner_offsets_[h];
    std::vector<std::uint32_t> next(partner_offsets_.data(), partner_offsets_.data() + hinges_.size());
    for (const HingePair& pair : bending.pairs) {
        const float weight = pair.weight * hinges_[pair.first].length * hinges_[pair.second].length;
        partners_[next[pair.first]++] = {pair.second, weight};
        partners_[next[pair.second]++] = {pair.first, weight};
    }
}

void HingeElements::compute(Parallel& parallel, const HingePass& pass) {
    const auto count = static_cast<std::uint32_t>(hinges_.size());
    parallel.ranges(count, [&](const BlockRange& range) {
        for (std::uint32_t h = range.begin; h < range.end; ++h) bend(pass, h);
    });
    parallel.ranges(count, [&](const BlockRange& range) {
        for (std::uint32_t h = range.begin; h < range.end; ++h) sum_moments(pass.rigidity, h);
    });
}

void HingeElements::bend(const HingePass& pass, std::uint32_t h) {
    // The least height over that at rest: lower ones count as this, as a collapsed triangle has no normal.
    constexpr float least_part = 0.05f;
    const Hinge& hinge = hinges_[h];
    std::array<Vector3, 4> x;
    for (std::size_t k = 0; k < 4; ++k) x[k] = xyz(pass.positions[hinge.particles[k]]);
    const Dihedral present = dihedral(x, least_part * hinge.least_height);
    bends_[h] = nearest_turn(present.angle - hinge.angle);
    for (std::size_t k = 0; k < 4; ++k) {
        results_[4 * std::size_t{h} + k] = to_vec4(present.gradient[k], 0);
        if (!pass.velocities.empty())
            bends_[h] += pass.viscosity * present.gradient[k].dot(xyz(pass.velocities[hinge.particles[k]]));
    }
}

void HingeElements::sum_moments(float rigidity, std::uint32_t h) {
    const Hinge& hinge = hinges_[h];
    const float own = hinge.weight * hinge.length * hinge.length;
    float moment = own * bends_[h], stiffness = own;
    for (std::uint32_t p = partner_offsets_[h]; p < partner_offsets_[h + 1]; ++p) {
        moment += partners_[p].weight * bends_[partners_[p].hinge];
        stiffness += partners_[p].weight;
    }
    results_[4 * std::size_t{h}].w = -rigidity * moment;
    results_[4 * std::size_t{h} + 1].w = rigidity * stiffness;
}

}  // namespace weft
