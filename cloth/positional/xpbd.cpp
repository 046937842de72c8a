#include "cloth/positional/xpbd.h"

#include <algorithm>

#include "cloth/forces/springs.h"

namespace weft {

namespace {

// Springs are cheap and colours many: smaller blocks cost more to hand out than they save.
constexpr std::uint32_t springs_per_block = 2048;
static_assert(springs_per_block % SpringColours::lanes == 0);

}  // namespace

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
                         const ClothState& state) {
    for (std::uint32_t s = 0; s < colours_.springs(); ++s) {
        if (colours_.half_edges[s] == SpringColours::no_half_edge) continue;
        springs_.first_weights[s] = state.positions[colours_.first[s]].w;
        springs_.second_weights[s] = state.positions[colours_.second[s]].w;
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

void XpbdSolver::sweep(Parallel& parallel, float gamma, SweepOrder order) {
    for (std::uint32_t c = 0; c < colours_.colours(); ++c) {
        const std::uint32_t begin = colours_.offsets[c], end = colours_.offsets[c + 1];
        parallel.blocks((end - begin + springs_per_block - 1) / springs_per_block, [&](std::uint32_t block) {
            const std::uint32_t from = begin + block * springs_per_block;
            project_springs(colours_, from, std::min(end, from + springs_per_block), gamma, order, springs_,
                            displacements_.start().data(), displacements_.moved().data());
        });
    }
}

float XpbdSolver::solve(const SolverStep& step) {
    const auto timer = step.timed(Stage::solve);
    const float h = step.equation.h;
    find_responses(step.model, step.settings.fabric, h);
    displacements_.predict(step);
    const int iterations = std::get<Xpbd>(step.settings.method).iterations;
    for (int k = 0; k < iterations; ++k) {
        sweep(step.parallel, step.settings.fabric.damping / h,
              {.first = k == 0, .last = k + 1 == iterations});
    }
    displacements_.find_velocity_change(step);
    return 0;
}

std::size_t XpbdSolver::bytes() const noexcept {
    return colours_.bytes() + springs_.bytes() + displacements_.bytes();
}

}  // namespace weft
