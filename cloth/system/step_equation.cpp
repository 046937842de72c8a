#include "cloth/system/step_equation.h"

namespace weft {

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
            const Vector3 acceleration =
                external.gravity - external.air_damping * v + inverse_mass * xyz(air);
            const float row_sum = 1.0f + h * (external.air_damping + inverse_mass * air.w);
            predicted[i] = to_vec4(v + h * acceleration / row_sum, 0);
        }
    });
}

}  // namespace weft
