#include "cloth/methods/explicit/symplectic_euler.h"

namespace weft {

SymplecticEulerSolver::SymplecticEulerSolver(const ClothModel& model, const ClothSettings& settings)
    : kind_(settings), system_(make_system(model, settings)), residual_(model, settings) {}

void SymplecticEulerSolver::lay_out(Scratch& scratch, std::size_t pairs) {
    Solver::lay_out(scratch, pairs);
    system_->lay_out(scratch);
    residual_.lay_out(scratch);
}

bool SymplecticEulerSolver::serves(const ClothSettings& settings) const {
    return std::holds_alternative<SymplecticEuler>(settings.method) && kind_ == SystemKind(settings);
}

// A system's residual is gamma f(x_base + gamma v, v) about v_base: where gamma is so small that x + gamma v
// rounds to x, it is gamma times the present force. A gamma that is a power of two costs no digit.
SolveResult SymplecticEulerSolver::solve(const SolverStep& step) {
    constexpr float instant = 0x1p-40f;  // [s]; 1e-10 m at 100 m/s
    const StepEquation& equation = step.equation;
    StepEquation present = equation;
    present.gamma = instant;
    {
        const auto timer = step.timed(Stage::assemble);
        system_->residual(step.parallel, present, equation.velocities, step.velocities);
    }
    const auto timer = step.timed(Stage::solve);
    const ExternalForces& external = equation.external;
    step.parallel.ranges(static_cast<std::uint32_t>(step.velocities.size()), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const float inverse_mass = equation.positions[i].w;
            const float air_slope = external.air.empty() ? 0.0f : external.air[i].w;
            const float row_sum = 1.0f + equation.h * (external.air_damping + inverse_mass * air_slope);
            const Vector3 impulse = xyz(step.velocities[i]) * (equation.h / instant);
            const Vector3 v = xyz(equation.velocities[i]) + inverse_mass * impulse / row_sum;
            step.velocities[i] = to_vec4(v, 0);
        }
    });
    return {.residual = residual_(step, system_.get())};
}

std::size_t SymplecticEulerSolver::bytes() const noexcept {
    return system_->bytes();
}

}  // namespace weft
