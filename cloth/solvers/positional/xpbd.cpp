#include "cloth/solvers/positional/xpbd.h"

#include "cloth/system/springs/springs.h"

namespace weft {

XpbdSolver::XpbdSolver(const CookedCloth& model, const ClothSettings& /*settings*/)
    : colours_(colour_springs(model)),
      springs_(colours_.springs()),
      displacements_(model.particle_count, SpringColours::stand_ins) {
    for (std::uint32_t s = 0; s < colours_.springs(); ++s) {
        const std::uint32_t half_edge = colours_.half_edges[s];
        if (half_edge != SpringColours::no_half_edge)
            springs_.rest_lengths[s] = model.rest_lengths[half_edge];
    }
}

void XpbdSolver::prepare(const CookedCloth& /*model*/, const ClothSettings& /*settings*/,
                         std::span<const Vec4> positions) {
    for (std::uint32_t s = 0; s < colours_.springs(); ++s) {
        if (colours_.half_edges[s] == SpringColours::no_half_edge) continue;
        springs_.first_weights[s] = positions[colours_.first[s]].w;
        springs_.second_weights[s] = positions[colours_.second[s]].w;
    }
    h_ = 0;
}

// With kappa = k h^2 = 1 / alpha~:  response = kappa / (1 + kappa (1 + gamma) (w_a + w_b)), release =
// response / kappa.
void XpbdSolver::find_responses(const CookedCloth& model, const Fabric& fabric, float h) {
    if (h == h_) return;
    h_ = h;
    const std::array<float, 3> stiffness = stiffnesses(fabric);
    const float gamma = fabric.damping / h;
    for (std::uint32_t s = 0; s < colours_.springs(); ++s) {
        const std::uint32_t half_edge = colours_.half_edges[s];
        if (half_edge == SpringColours::no_half_edge) continue;
        const float kappa = stiffness[static_cast<std::size_t>(model.kinds[half_edge])] * h * h;
        const float weight = springs_.first_weights[s] + springs_.second_weights[s];
        springs_.releases[s] = 1.0f / (1.0f + kappa * (1.0f + gamma) * weight);
        springs_.responses[s] = kappa * springs_.releases[s];
    }
}

float XpbdSolver::solve(const SolverStep& step) {
    const auto timer = step.timed(Stage::solve);
    const float h = step.equation.h;
    find_responses(step.model, step.settings.fabric, h);
    displacements_.predict(step);
    const int iterations = std::get<Xpbd>(step.settings.method).iterations;
    for (int k = 0; k < iterations; ++k) {
        sweep_springs(step.parallel, colours_, step.settings.fabric.damping / h,
                      {.first = k == 0, .last = k + 1 == iterations}, springs_, displacements_.start().data(),
                      displacements_.moved().data());
    }
    displacements_.find_velocity_change(step);
    return 0;
}

std::size_t XpbdSolver::bytes() const noexcept {
    return colours_.bytes() + springs_.bytes() + displacements_.bytes();
}

}  // namespace weft
