#include "cloth/methods/positional/bending_step.h"

#include <algorithm>
#include <vector>

namespace weft {

namespace {

/// The particles of all corners; where an element has no fourth, a stand-in.
std::vector<std::uint32_t> corners_of(const std::vector<BendingElement>& elements, std::uint32_t stand_in) {
    std::vector<std::uint32_t> corners;
    corners.reserve(4 * elements.size());
    for (const BendingElement& element : elements)
        for (std::size_t k = 0; k < 4; ++k)
            corners.push_back(element.c[k] != 0 ? element.particles[k] : stand_in);
    return corners;
}

}  // namespace

BendingStep::BendingStep(const ClothModel& model, const std::vector<BendingElement>& elements)
    : elements_(elements.size()),
      impulses_(elements.size()),
      bounds_(model.particle_count),
      occurrences_(corners_of(elements, model.particle_count), model.particle_count) {
    std::ranges::copy(elements, elements_.data());
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        bounds_[i] = model.bending_excess[i];
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e)
            bounds_[i] += model.bending[e];
    }
}

// With s = B h^2, d = 1 + damping / h and D_i the number that bounds half of bending's Hessian at particle i
// (see ClothModel), an element of positions x that have moved by u gives its particles the impulses
//   -c_i s k sum_a c_a (x_a + (d - 1) u_a) / (1 + max_a (s d D_a / m_a)).
void BendingStep::apply(const SolverStep& step, std::span<const Vec4> start, std::span<Vec4> moved) {
    const Fabric& fabric = step.settings.fabric;
    const float h = step.equation.h, scale = step.equation.rigidity * h * h, viscous = fabric.damping / h;
    const std::span<const Vec4> masses = step.equation.positions;  // inverse, in w
    step.parallel.ranges(static_cast<std::uint32_t>(elements_.size()), [&](const BlockRange& range) {
        for (std::uint32_t e = range.begin; e < range.end; ++e) {
            const BendingElement& element = elements_[e];
            Vector3 bend = Vector3::Zero();
            float stiffest = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                const std::uint32_t i = element.particles[k];
                bend += element.c[k] * (xyz(start[i]) + (1 + viscous) * xyz(moved[i]));
                stiffest = std::max(stiffest, masses[i].w * bounds_[i]);
            }
            impulses_[e] = to_vec4(-element.k / (1 + scale * (1 + viscous) * stiffest) * bend, 0);
        }
    });
    step.parallel.ranges(step.model.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            Vector3 sum = Vector3::Zero();
            for (const std::uint32_t at : occurrences_.of(i))
                sum += elements_[at / 4].c[at % 4] * xyz(impulses_[at / 4]);
            moved[i] = to_vec4(xyz(moved[i]) + scale * masses[i].w * sum, 0);
        }
    });
}

}  // namespace weft
