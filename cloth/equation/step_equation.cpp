#include "cloth/equation/step_equation.h"

#include "cloth/equation/filling_row.h"

namespace weft {

namespace {

/// Force of the filling on a particle [N].
Vector3 force_of_filling(const ExternalForces& external, std::uint32_t i) {
    if (external.filling == nullptr) return Vector3::Zero();
    return external.filling->pressure() * xyz(external.filling->gradient()[i]);
}

}  // namespace

ExternalRow external_row(const StepEquation& equation, std::uint32_t i) {
    const ExternalForces& forces = equation.external;
    const float w = equation.base_positions[i].w;
    const Vector3 v = xyz(equation.velocities[i]);
    if (w == 0) return {v, 0};
    const Vec4 air = forces.air.empty() ? Vec4{} : forces.air[i];
    const float mass = 1 / w, gamma = equation.gamma;
    const float row_sum = mass * (1 + gamma * forces.air_damping) + gamma * air.w;
    Vector3 impulse =
        mass * (xyz(equation.base_velocities[i]) + gamma * forces.gravity) + gamma * (xyz(air) + air.w * v);
    if (forces.filling != nullptr) impulse += gamma * force_of_filling(forces, i);
    return {impulse / row_sum, row_sum};
}

void predict_velocities(Parallel& parallel, const StepEquation& equation, std::span<Vec4> predicted) {
    const ExternalForces& external = equation.external;
    const float h = equation.h;
    parallel.ranges(static_cast<std::uint32_t>(predicted.size()), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const Vector3 v = xyz(equation.velocities[i]);
            const float inverse_mass = equation.positions[i].w;
            if (inverse_mass == 0) {
                predicted[i] = to_vec4(v, 0);
                continue;
            }
            const Vec4 air = external.air.empty() ? Vec4{} : external.air[i];
            Vector3 acceleration = external.gravity - external.air_damping * v + inverse_mass * xyz(air);
            if (external.filling != nullptr) acceleration += inverse_mass * force_of_filling(external, i);
            const float row_sum = 1.0f + h * (external.air_damping + inverse_mass * air.w);
            predicted[i] = to_vec4(v + h * acceleration / row_sum, 0);
        }
    });
}

}  // namespace weft
