#include "cloth/solvers/positional/displacements.h"

namespace weft {

Displacements::Displacements(std::uint32_t particles, std::uint32_t stand_ins)
    : start_(particles + stand_ins), moved_(particles + stand_ins) {
    for (std::uint32_t i = 0; i < stand_ins; ++i) start_[particles + i].x = static_cast<float>(i);
}

void Displacements::predict(const SolverStep& step) {
    const StepEquation& equation = step.equation;
    predict_velocities(step.parallel, equation, step.velocities);
    step.parallel.ranges(step.model.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            start_[i] = to_vec4(xyz(equation.positions[i]), 0);
            moved_[i] = to_vec4(equation.h * xyz(step.velocities[i]), 0);
        }
    });
}

// v = (p - x) / h (Mueller, Heidelberger, Hennix, Ratcliff 2007, line 13).
void Displacements::find_velocities(const SolverStep& step) const {
    const StepEquation& equation = step.equation;
    const float inverse_h = 1.0f / equation.h;
    step.parallel.ranges(step.model.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const bool pinned = equation.positions[i].w == 0;
            const Vector3 v = inverse_h * xyz(moved_[i]);
            step.velocities[i] = to_vec4(pinned ? xyz(equation.velocities[i]) : v, 0);
        }
    });
}

}  // namespace weft
