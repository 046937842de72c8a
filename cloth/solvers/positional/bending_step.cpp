#include "cloth/solvers/positional/bending_step.h"

#include <algorithm>
#include <array>
#include <vector>

namespace weft {

BendingStep::BendingStep(const CookedCloth& model) : offsets_(model.particle_count + 1) {
    const std::vector<BendingElement> elements = linear_bending(model);
    elements_ = AlignedBuffer<BendingElement>(elements.size());
    impulses_ = AlignedBuffer<Vec4>(elements.size());
    std::ranges::copy(elements, elements_.data());
    const auto for_each_corner = [&](const auto& body) {
        for (std::uint32_t e = 0; e < elements.size(); ++e)
            for (std::uint32_t k = 0; k < 4; ++k)
                if (elements[e].c[k] != 0) body(elements[e].particles[k], 4 * e + k);
    };
    for_each_corner([&](std::uint32_t particle, std::uint32_t) { ++offsets_[particle + 1]; });
    for (std::uint32_t i = 0; i < model.particle_count; ++i) offsets_[i + 1] += offsets_[i];
    corners_ = AlignedBuffer<std::uint32_t>(offsets_[model.particle_count]);
    std::vector<std::uint32_t> next(offsets_.data(), offsets_.data() + model.particle_count);
    for_each_corner(
        [&](std::uint32_t particle, std::uint32_t corner) { corners_[next[particle]++] = corner; });
}

// With s = B h^2, d = 1 + damping / h and D_i the number that bounds half of bending's Hessian at particle i
// (see CookedCloth), an element of positions x that have moved by u gives its particles the impulses
//   -c_i s k sum_a c_a (x_a + (d - 1) u_a) / (1 + max_a (s d D_a / m_a)).
void BendingStep::apply(const SolverStep& step, std::span<const Vec4> start, std::span<Vec4> moved) {
    const CookedCloth& model = step.model;
    const Fabric& fabric = step.settings.fabric;
    const float h = step.equation.h, scale = fabric.bending * h * h, viscous = fabric.damping / h;
    const std::span<const Vec4> masses = step.equation.positions;  // inverse, in w
    const auto bound = [&](std::uint32_t i) {
        float sum = model.bending_excess[i];
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e)
            sum += model.bending[e];
        return masses[i].w * sum;
    };
    step.parallel.ranges(static_cast<std::uint32_t>(elements_.size()), [&](const BlockRange& range) {
        for (std::uint32_t e = range.begin; e < range.end; ++e) {
            const BendingElement& element = elements_[e];
            Vector3 bend = Vector3::Zero();
            float stiffest = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                const std::uint32_t i = element.particles[k];
                bend += element.c[k] * (xyz(start[i]) + (1 + viscous) * xyz(moved[i]));
                stiffest = std::max(stiffest, bound(i));
            }
            impulses_[e] = to_vec4(-element.k / (1 + scale * (1 + viscous) * stiffest) * bend, 0);
        }
    });
    step.parallel.ranges(model.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            Vector3 sum = Vector3::Zero();
            for (std::uint32_t at = offsets_[i]; at < offsets_[i + 1]; ++at) {
                const std::uint32_t element = corners_[at] / 4, corner = corners_[at] % 4;
                sum += elements_[element].c[corner] * xyz(impulses_[element]);
            }
            moved[i] = to_vec4(xyz(moved[i]) + scale * masses[i].w * sum, 0);
        }
    });
}

}  // namespace weft
