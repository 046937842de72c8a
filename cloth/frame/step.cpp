// The frame: one function that reads as the method, and the stages that it names.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "cloth/frame/advance.h"
#include "cloth/frame/simulation.h"
#include "cloth/surface/gusts.h"

namespace weft {

namespace {

Vector3 limited(const Vector3& velocity, float max_speed) {
    const float squared = velocity.squaredNorm();
    return squared > max_speed * max_speed ? Vector3(velocity * (max_speed / std::sqrt(squared))) : velocity;
}

}  // namespace

void Simulation::step(float dt) {
    begin();
    for_each_cloth([&](Worker& worker, Cloth& cloth) {
        const auto timer = timed(Stage::cloths);
        begin_cloth(cloth, dt);
        feel_wind(worker, cloth);
        const int substeps = settings.substeps * cloth.settings.substeps;
        const auto all = static_cast<float>(substeps);
        for (int s = 0; s < substeps; ++s) {
            move_colliders(worker, static_cast<float>(s) / all, static_cast<float>(s + 1) / all);
            air_forces(worker, cloth, s == 0);
            const StepEquation equation = equation_of(worker, cloth, dt / all);
            solve(worker, cloth, equation);
            advance(worker, cloth, equation, s == 0);
            hold_by_tethers(worker, cloth);
            collide_with_colliders(worker, cloth, equation.h);
            avoid_self_collision(worker, cloth, equation.h);
        }
        guard(worker, cloth);
        finish(worker, cloth);
    });
    end(dt);
}

// Cloths do not meet: each takes its whole step by itself. First the threads take small cloths, each the next
// that is left, then all of them work on one large cloth after the other. No loop runs within another.
template <class StepCloth>
void Simulation::for_each_cloth(const StepCloth& step_cloth) {
    schedule_.plan(cloths, parallel.width());
    const std::span<const Schedule::Entry> small = schedule_.side_by_side();
    std::atomic<std::size_t> next = 0;
    parallel.blocks(static_cast<std::uint32_t>(std::min(motions_.size(), small.size())),
                    [&](std::uint32_t thread) {
                        Worker worker{serial_, motions_[thread]};
                        for (std::size_t i; (i = next.fetch_add(1)) < small.size();)
                            step_cloth(worker, *small[i].cloth);
                    });
    Worker all{parallel, motions_[0]};
    for (const Schedule::Entry& entry : schedule_.in_turn()) step_cloth(all, *entry.cloth);
}

void Simulation::begin() {
    profiler.begin_step();
    report = {.step = report.step + 1, .substeps = settings.substeps};
}

void Simulation::begin_cloth(Cloth& cloth, float dt) const {
    cloth.residual = 0;
    for (const Pin& pin : cloth.pins) {
        const Vector3 velocity = (pin.target - xyz(cloth.state.positions[pin.particle])) / dt;
        set_xyz(cloth.state.velocities[pin.particle], limited(velocity, settings.max_speed));
    }
}

void Simulation::move_colliders(Worker& worker, float begin, float end) const {
    worker.motions.clear();
    colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
        worker.motions.push_back({blend(slot.current, slot.target, begin),
                                  blend(slot.current, slot.target, end), settings.max_speed});
    });
}

// Gusts change little in a step: they are sampled once, at its start, and felt in every substep.
void Simulation::feel_wind(Worker& worker, Cloth& cloth) {
    if (!air_is_on() || cloth.air_velocities.size() == 0) return;
    const auto timer = timed(Stage::wind);
    WindField(settings.wind, wind_path, time)
        .sample(worker.parallel, cloth.state.positions.span(), cloth.air_velocities.span());
}

// A step begins with the normals that the last one ended with, since only steps move particles.
void Simulation::air_forces(Worker& worker, Cloth& cloth, bool first_substep) {
    if (!air_is_on()) return;
    const auto timer = timed(Stage::wind);
    cloth.surface.compute_air_forces(worker.parallel,
                                     {.wind = settings.wind,
                                      .positions = cloth.state.positions.span(),
                                      .velocities = cloth.state.velocities.span(),
                                      .air_velocities = cloth.air_velocities.span(),
                                      .has_moved = !first_substep},
                                     cloth.air_forces.span());
}

StepEquation Simulation::equation_of(Worker& worker, Cloth& cloth, float h) {
    const ClothState& state = cloth.state;
    const bool second_order = cloth.history && cloth.history->holds(h);
    if (second_order) {
        const auto timer = timed(Stage::assemble);
        cloth.history->begin(worker.parallel, state);
    }
    return {.settings = cloth.settings,
            .h = h,
            .gamma = second_order ? History::gamma(h) : h,
            .positions = state.positions.span(),
            .velocities = state.velocities.span(),
            .base_positions = second_order ? cloth.history->base_positions() : state.positions.span(),
            .base_velocities = second_order ? cloth.history->base_velocities() : state.velocities.span(),
            .external = {.gravity = to_vector(settings.gravity),
                         .air_damping = cloth.settings.air_damping,
                         .air = std::as_const(cloth.air_forces).span()},
            .contacts = cloth.contacts ? &*cloth.contacts : nullptr};
}

void Simulation::solve(Worker& worker, Cloth& cloth, const StepEquation& equation) {
    if (!cloth.solver_is_prepared) {
        cloth.solver->prepare(cloth.model, cloth.settings, cloth.state.positions.span());
        cloth.solver_is_prepared = true;
    }
    if (cloth.contacts) cloth.contacts->begin(worker.motions);
    const float residual = cloth.solver->solve({.parallel = worker.parallel,
                                                .profiler = profiler,
                                                .model = cloth.model,
                                                .settings = cloth.settings,
                                                .equation = equation,
                                                .touches_collider = cloth.collider_contacts > 0,
                                                .velocity_change = cloth.velocity_change.span()});
    if (cloth.contacts)
        cloth.contacts->finish(worker.parallel, equation, std::as_const(cloth.velocity_change).span());
    cloth.solver_failed |= std::isnan(residual);
    cloth.residual = std::max(cloth.residual, residual);
}

// The first substep writes the new positions over the previous ones and swaps the two, so that the start of
// the step stays behind for the renderer's blend and for guard().
void Simulation::advance(Worker& worker, Cloth& cloth, const StepEquation& equation, bool first_substep) {
    const auto timer = timed(Stage::advance);
    ClothState& state = cloth.state;
    weft::advance(worker.parallel, equation,
                  {.velocity_changes = std::as_const(cloth.velocity_change).span(),
                   .max_speed = settings.max_speed,
                   .velocities = state.velocities.span(),
                   .positions = (first_substep ? state.previous_positions : state.positions).span(),
                   .history = cloth.history ? &*cloth.history : nullptr});
    if (first_substep) std::swap(state.positions, state.previous_positions);
}

void Simulation::hold_by_tethers(Worker& worker, Cloth& cloth) {
    if (!cloth.tethers) return;
    const auto timer = timed(Stage::tethers);
    if (!cloth.tethers_are_attached) {
        std::vector<std::uint32_t> particles;
        for (const Pin& pin : cloth.pins) particles.push_back(pin.particle);
        cloth.tethers->attach(cloth.model, particles);
        cloth.tethers_are_attached = true;
    }
    cloth.tethers->hold(worker.parallel, cloth.settings.tethers.slack, cloth.state.positions.span(),
                        cloth.state.velocities.span());
}

void Simulation::collide_with_colliders(Worker& worker, Cloth& cloth, float h) {
    cloth.collider_contacts = 0;
    if (worker.motions.empty()) return;
    const auto timer = timed(Stage::colliders);
    cloth.collider_contacts =
        collide(worker.parallel, worker.motions, cloth.settings.thickness, cloth.settings.friction, h,
                cloth.contacts ? std::as_const(*cloth.contacts).normals() : std::span<const Vec4>(),
                cloth.state.positions.span(), cloth.state.velocities.span(), cloth.partial_counts.span());
}

void Simulation::avoid_self_collision(Worker& worker, Cloth& cloth, float h) {
    if (!cloth.self_contacts) return;
    const float distance = cloth.rest_neighbours->distance();
    {
        const auto timer = timed(Stage::self_search);
        cloth.self_contacts->find(worker.parallel, cloth.state.positions.span(),
                                  cloth.rest_neighbours->filter(), distance,
                                  cloth.settings.self_collision.search);
    }
    const auto timer = timed(Stage::self_response);
    cloth.self_counts =
        cloth.self_contacts->respond(worker.parallel, distance, cloth.settings.self_collision.friction, h,
                                     cloth.state.positions.span(), cloth.state.velocities.span());
}

void Simulation::guard(Worker& worker, Cloth& cloth) {
    const auto timer = timed(Stage::guard);
    cloth.extent = survey(worker.parallel, cloth.state, cloth.partial_surveys.span());
    cloth.restored = std::exchange(cloth.solver_failed, false) || !cloth.extent.sound;
    if (cloth.restored) {
        cloth.restore_start_of_step();
        cloth.extent = survey(worker.parallel, cloth.state, cloth.partial_surveys.span());
    }
    // Neither rounding nor the speed limit may make a pin miss its target.
    for (const Pin& pin : cloth.pins) set_xyz(cloth.state.positions[pin.particle], pin.target);
}

void Simulation::finish(Worker& worker, Cloth& cloth) {
    const auto timer = timed(Stage::normals);
    update_normals(worker.parallel, cloth);
}

void Simulation::add_to_report(const Cloth& cloth) {
    ++report.cloths;
    report.particles += cloth.model.particle_count;
    report.collider_contacts += cloth.collider_contacts;
    report.self_contacts += cloth.self_counts.pairs;
    report.peak_self_contacts = std::max(report.peak_self_contacts, cloth.self_counts.peak);
    report.peak_speed = std::max(report.peak_speed, std::sqrt(cloth.extent.peak_speed_squared));
    report.residual = std::max(report.residual, cloth.residual);
    if (cloth.restored) {
        report.flags = report.flags | StepFlags::state_restored;
        ++report.restored_cloths;
    }
    if (report.peak_speed > 0.999f * settings.max_speed)
        report.flags = report.flags | StepFlags::speed_limited;
    if (cloth.self_counts.dropped > 0) report.flags = report.flags | StepFlags::contacts_dropped;
}

void Simulation::end(float dt) {
    cloths.for_each([&](ClothId, const std::unique_ptr<Cloth>& cloth) { add_to_report(*cloth); });
    const Vec3& wind = settings.wind.velocity;
    wind_path[0] += static_cast<double>(wind.x) * static_cast<double>(dt);
    wind_path[1] += static_cast<double>(wind.y) * static_cast<double>(dt);
    wind_path[2] += static_cast<double>(wind.z) * static_cast<double>(dt);
    time += static_cast<double>(dt);
    colliders.for_each([](ColliderId, ColliderSlot& slot) { slot.current = slot.target; });
    profiler.end_step();
    report.milliseconds = profiler.last_step_ms();
}

}  // namespace weft
