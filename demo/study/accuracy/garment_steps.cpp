#include "demo/study/accuracy/garment_steps.h"

#include "cloth/equation/step_equation.h"

namespace weft::study {

namespace {

std::vector<Vec4> rounded(const Positions& positions) {
    std::vector<Vec4> result;
    for (const Eigen::Vector3d& x : positions) result.push_back(to_vec4(x.cast<float>(), 0));
    return result;
}

StepEquation equation_of(const Run& run, const StudyScene& scene) {
    const Cloth& cloth = run.cloth();
    return {
        .settings = cloth.settings,
        .h = scene.frame,
        .gamma = scene.frame,
        .rigidity = cloth.settings.fabric.bending,
        .positions = cloth.state.positions.span(),
        .velocities = cloth.state.velocities.span(),
        .base_positions = cloth.state.positions.span(),
        .base_velocities = cloth.state.velocities.span(),
        .external = {
            .gravity = to_vector(scene.world.gravity), .air_damping = cloth.settings.air_damping, .air = {}}};
}

/// Velocities after one frame under gravity alone.
Flat inertial(const Run& run, const StudyScene& scene) {
    const ClothState& state = run.cloth().state;
    const Eigen::Vector3d fall =
        static_cast<double>(scene.frame) * to_vector(scene.world.gravity).cast<double>();
    Flat velocities = flat(state.velocities.span());
    for (std::uint32_t i = 0; i < state.size(); ++i)
        if (state.positions[i].w > 0) velocities.segment<3>(3 * static_cast<Eigen::Index>(i)) += fall;
    return velocities;
}

}  // namespace

GarmentSteps::GarmentSteps(const StudyScene& garment, ReferenceStore& store, int threads)
    : garment_(garment) {
    std::vector<int> needed;
    for (const int frame : frames) {
        needed.push_back(frame - 1);
        needed.push_back(frame);
    }
    const States states = store.states(garment_, Reference::rough, needed);
    for (const int frame : frames)
        steps_.push_back(make_step(states.at(frame - 1), states.at(frame), threads));
}

// Backward Euler's velocity is that of its last displacement.
GarmentSteps::Step GarmentSteps::make_step(const Positions& before, const Positions& now, int threads) const {
    StudyScene start = garment_;
    start.start_positions = rounded(now);
    Positions velocities;
    for (std::size_t i = 0; i < now.size(); ++i)
        velocities.emplace_back((now[i] - before[i]) / static_cast<double>(start.frame));
    start.start_velocities = rounded(velocities);

    Run run(start, method_of(Reference::converged), threads);
    Step step{start,
              StepFunctional(run.cloth().model, equation_of(run, start)),
              flat(run.cloth().state.positions.span()),
              {},
              {},
              0,
              0};
    const Flat inertial_start = inertial(run, start);
    run.step();
    step.solution = positions_of(run.cloth());
    const Flat solution = velocities_to(step, step.solution);
    step.damped = step.functional.damped_states(solution);
    step.solved = step.functional.value(solution, step.damped);
    step.inertial = step.functional.value(inertial_start, step.damped);
    return step;
}

Flat GarmentSteps::velocities_to(const Step& step, const Positions& positions) const {
    Flat velocities(step.start_positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Eigen::Index at = 3 * static_cast<Eigen::Index>(i);
        velocities.segment<3>(at) =
            (positions[i] - step.start_positions.segment<3>(at)) / static_cast<double>(step.start.frame);
    }
    return velocities;
}

GarmentSteps::Judgement GarmentSteps::judge(std::size_t index, const Cloth& after) const {
    const Step& step = steps_[index];
    const Positions positions = positions_of(after);
    const double value = step.functional.value(velocities_to(step, positions), step.damped);
    return {rms_distance(positions, step.solution), (value - step.solved) / (step.inertial - step.solved)};
}

}  // namespace weft::study
