#include "cloth/methods/positional/displacements.h"

#include <algorithm>

namespace weft {

Displacements::Displacements(const ClothModel& model, std::uint32_t stand_ins)
    : bending_(model), start_(model.particle_count + stand_ins), moved_(start_.size()) {
    for (std::uint32_t i = 0; i < stand_ins; ++i) start_[model.particle_count + i].x = static_cast<float>(i);
}

void Displacements::predict(const SolverStep& step) {
    const StepEquation& equation = step.equation;
    predict_velocities(step.parallel, equation, step.velocities);
    // Stand-ins do not move, but 0 times a value that is not finite may have been added to them.
    std::fill(moved_.data() + step.model.particle_count, moved_.data() + moved_.size(), Vec4{});
    step.parallel.ranges(step.model.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            start_[i] = to_vec4(xyz(equation.positions[i]), 0);
            moved_[i] = to_vec4(equation.h * xyz(step.velocities[i]), 0);
        }
    });
    if (step.settings.fabric.bending > 0) bending_.apply(step, start_.span(), moved_.span());
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
