#include "cloth/methods/positional/xpbd.h"

#include "cloth/fabric/springs/membrane.h"

namespace weft {

XpbdSolver::XpbdSolver(const ClothModel& model, std::span<const Vec4> positions)
    : model_(model),
      colours_(colour_springs(model)),
      firsts_(colours_.first.span(), model.particle_count),
      seconds_(colours_.second.span(), model.particle_count),
      springs_(colours_.springs()),
      displacements_(model, SpringColours::stand_ins),
      stiffness_(model.neighbours.size()),
      residual_(model, {}) {
    for (std::uint32_t s = 0; s < colours_.springs(); ++s) {
        const std::uint32_t half_edge = colours_.half_edges[s];
        if (half_edge != SpringColours::no_half_edge)
            springs_.rest_lengths[s] = model.rest_lengths[half_edge];
    }
    inverse_masses_changed(positions);
}

void XpbdSolver::inverse_mass_changed(std::uint32_t particle, std::span<const Vec4> positions) noexcept {
    for (const std::uint32_t s : firsts_.of(particle)) {
        springs_.first_weights[s] = positions[particle].w;
        find_response(s);
    }
    for (const std::uint32_t s : seconds_.of(particle)) {
        springs_.second_weights[s] = positions[particle].w;
        find_response(s);
    }
}

void XpbdSolver::inverse_masses_changed(std::span<const Vec4> positions) noexcept {
    for (std::uint32_t i = 0; i < positions.size(); ++i) inverse_mass_changed(i, positions);
}

void XpbdSolver::find_responses(const Fabric& fabric, float h) noexcept {
    if (h == h_ && fabric == fabric_) return;
    spring_stiffness(model_, fabric, stiffness_.span());
    fabric_ = fabric;
    h_ = h;
    for (std::uint32_t s = 0; s < colours_.springs(); ++s) find_response(s);
}

// With kappa = k h^2 = 1 / alpha~:  response = kappa / (1 + kappa (1 + gamma) (w_a + w_b)), release =
// response / kappa.
void XpbdSolver::find_response(std::uint32_t spring) noexcept {
    const std::uint32_t half_edge = colours_.half_edges[spring];
    if (half_edge == SpringColours::no_half_edge) return;
    const float kappa = stiffness_[half_edge] * h_ * h_;
    const float gamma = h_ > 0 ? fabric_.damping / h_ : 0;
    const float weight = springs_.first_weights[spring] + springs_.second_weights[spring];
    springs_.releases[spring] = 1.0f / (1.0f + kappa * (1.0f + gamma) * weight);
    springs_.responses[spring] = kappa * springs_.releases[spring];
}

SolveResult XpbdSolver::solve(const SolverStep& step) {
    const auto timer = step.timed(Stage::solve);
    const Fabric& fabric = step.settings.fabric;
    const float h = step.equation.h, gamma = fabric.damping / h;
    find_responses(fabric, h);
    displacements_.predict(step);
    const int iterations = std::get<Xpbd>(step.settings.method).iterations;
    for (int k = 0; k < iterations; ++k) {
        sweep_springs(step.parallel, colours_, gamma, {.first = k == 0, .last = k + 1 == iterations},
                      springs_, displacements_.start().data(), displacements_.moved().data());
    }
    displacements_.find_velocities(step);
    return {.residual = residual_(step)};
}

std::size_t XpbdSolver::bytes() const noexcept {
    return colours_.bytes() + firsts_.bytes() + seconds_.bytes() + springs_.bytes() + displacements_.bytes() +
           stiffness_.bytes();
}

}  // namespace weft
