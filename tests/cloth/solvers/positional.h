#pragma once
// One step of a positional method on one cloth.

#include "cloth/instance/make_solver.h"
#include "cloth/solver/stages.h"
#include "engine/profiling/profiler.h"
#include "tests/cloth/fixtures.h"

namespace weft::test {

/// The velocity change that the cloth's solver finds for one step of length h.
inline AlignedBuffer<Vec4> velocity_change(Cloth& cloth, const Method& method, float h,
                                           const Vector3& gravity = {0, -9.81f, 0}) {
    cloth.settings.method = method;
    const auto solver = make_solver(cloth.model, cloth.settings, cloth.state.positions.span());
    AlignedBuffer<Vec4> change(cloth.model.particle_count);
    Parallel serial(1);
    Profiler profiler(stage_names);
    const StepEquation equation = equation_of(cloth, h, gravity);
    solver->solve({.parallel = serial,
                   .profiler = profiler,
                   .model = cloth.model,
                   .settings = cloth.settings,
                   .equation = equation,
                   .velocities = change.span()});
    for (std::uint32_t i = 0; i < change.size(); ++i)
        change[i] = to_vec4(xyz(change[i]) - xyz(cloth.state.velocities[i]), 0);
    return change;
}

inline bool all_finite(std::span<const Vec4> values) {
    return std::ranges::all_of(values, [](const Vec4& v) { return xyz(v).allFinite(); });
}

/// All in one, for tests that hold for each positional method.
inline std::vector<std::pair<const char*, Method>> positional_methods(int iterations) {
    using enum Fibres::SetSolver;
    return {{"xpbd", Xpbd{iterations}},
            {"fibres", Fibres{.iterations = iterations}},
            {"gauss_seidel", Fibres{iterations, gauss_seidel, gauss_seidel, gauss_seidel}},
            {"ldlt", Fibres{iterations, ldlt, ldlt, ldlt}}};
}

}  // namespace weft::test
