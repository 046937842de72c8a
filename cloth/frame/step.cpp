// The frame: how a World steps, and the phases that each step names.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "cloth/frame/advance/advance.h"
#include "cloth/frame/simulation.h"
#include "collision/particles/velocity_filter.h"

namespace weft {

namespace {

Vector3 limited(const Vector3& velocity, float max_speed) {
    const float squared = velocity.squaredNorm();
    return squared > max_speed * max_speed ? Vector3(velocity * (max_speed / std::sqrt(squared))) : velocity;
}

}  // namespace

void Simulation::step(float dt) {
    begin(dt);
    if (together_ || bodies_)
        step_together(dt);
    else
        step_each(dt);
    end(dt);
}

// Each phase spans the World, so that cloths that touch are solved together.
void Simulation::step_together(float dt) {
    for (int s = 0; s < settings.substeps; ++s) {
        const Substep substep = Substep{0, 1, dt}.part(s, settings.substeps, dt);
        begin_bodies(substep);
        for_each_cloth([&](Worker& worker, Cloth& cloth) {
            if (!cloth.is_gliding())
                predict(worker, cloth, cloth.stride() * dt, substep.times(cloth.stride()));
        });
        meet(substep);
        for_each_group(islands_, [&](Worker& worker, std::span<Cloth* const> island) {
            Cloth& first = *island.front();
            if (island.size() > 1)
                solve_island(worker, island, dt, substep);
            else if (!first.is_gliding())
                solve(worker, first, first.stride() * dt, substep.times(first.stride()));
        });
        part_strays(substep);
        end_bodies(substep);
    }
    for_each_cloth([&](Worker& worker, Cloth& cloth) {
        if (cloth.is_gliding()) return glide(worker, cloth);
        guard(worker, cloth);
        begin_stride(worker, cloth);
        finish(worker, cloth);
    });
}

// Cloths that cannot meet need not wait for one another: each takes all phases of all substeps while it is in
// the cache. A hundred flags lose a third of their time otherwise.
void Simulation::step_each(float dt) {
    for_each_cloth([&](Worker& worker, Cloth& cloth) {
        if (cloth.is_gliding()) return glide(worker, cloth);
        const float own = cloth.stride() * dt;
        for (int s = 0; s < settings.substeps; ++s) {
            const Substep substep = Substep{0, 1, own}.part(s, settings.substeps, own);
            predict(worker, cloth, own, substep);
            solve(worker, cloth, own, substep);
        }
        guard(worker, cloth);
        begin_stride(worker, cloth);
        finish(worker, cloth);
    });
}

// First the threads take what suits one of them, each the next group that is left, then all of them work on
// one large group after the other. No loop runs within another.
template <class Work>
void Simulation::for_each_group(const Schedule& schedule, const Work& work) {
    const auto take = [&](Worker& worker, const Schedule::Group& group) {
        const auto timer = timed(Stage::cloths);
        const std::int64_t begin = clock();
        work(worker, group.cloths);
        share_out_time(group, clock() - begin);
    };
    const std::span<const Schedule::Group> small = schedule.side_by_side();
    std::atomic<std::size_t> next = 0;
    parallel.blocks(static_cast<std::uint32_t>(std::min(motions_.size(), small.size())),
                    [&](std::uint32_t thread) {
                        Worker worker{serial_, motions_[thread], contact_reports_.of_thread(thread)};
                        for (std::size_t i; (i = next.fetch_add(1)) < small.size();) take(worker, small[i]);
                    });
    Worker all{parallel, motions_[0], contact_reports_.of_thread(0)};
    for (const Schedule::Group& group : schedule.in_turn()) take(all, group);
}

template <class Work>
void Simulation::for_each_cloth(const Work& work) {
    for_each_group(each_, [&](Worker& worker, std::span<Cloth* const> one) { work(worker, *one.front()); });
}

void Simulation::begin(float dt) {
    profiler.begin_step();
    report = {.step = ++state.steps, .substeps = settings.substeps};
    contact_reports_.clear();
    choose_present(dt);
    if (settings.budget > 0) choose_details();
    cloths.for_each([](ClothId, std::unique_ptr<Cloth>& cloth) { cloth->was_stepped = false; });
    for (Cloth* cloth : present_) {
        cloth->was_stepped = true;
        cloth->nanoseconds = 0;
        cloth->unsolved = false;
        cloth->pins_limited = false;
        cloth->contact_count = 0;
    }
    plan_carries(dt);
    each_.plan(present_, parallel.width());
}

/// A pin goes along a straight line to its target, all through the step.
void Simulation::move_pins(Cloth& cloth, float dt) const {
    for (const Pin& pin : cloth.state.pins) {
        const Vector3 wanted = (pin.target - xyz(cloth.state.positions[pin.particle])) / dt;
        const Vector3 velocity = limited(wanted, settings.max_speed);
        cloth.pins_limited |= velocity != wanted;
        set_xyz(cloth.state.velocities[pin.particle], velocity);
    }
}

// Gusts change little in a step: they are sampled once, at its start, and felt in every substep. A step
// begins with the normals that the last one ended with, since only steps move particles.
void Simulation::predict(Worker& worker, Cloth& cloth, float dt, const Substep& substep) {
    if (substep.is_first()) {
        if (cloth.carried) {
            carry(worker.parallel, *cloth.carried, cloth.state);
            limit_speeds(worker.parallel, settings.max_speed, cloth.state.velocities.span());
        }
        move_pins(cloth, dt);
    }
    if (!air_is_on()) return;
    if (substep.is_first()) feel_wind(worker, cloth);
    air_forces(worker, cloth, !substep.is_first() || cloth.carried);
}

// A cloth's own part of a substep. Its method's smaller steps lie between two meetings with other cloths, and
// meet its colliders each.
void Simulation::solve(Worker& worker, Cloth& cloth, float dt, const Substep& substep) {
    Cloth* const self = &cloth;
    const std::span<Cloth* const> alone(&self, 1);
    const bool with_bodies = cloth.meets_bodies;
    if (with_bodies) take_bodies(alone, substep.h);
    const int parts =
        cloth.settings.substeps * std::max(parts_of_step(alone), parts_to_meet(worker, cloth, substep));
    bool cut_much = false;
    for (int k = 0; k < parts; ++k) {
        const Substep part = substep.part(k, parts, dt);
        const Bdf bdf = cloth.bdf_of(part.h);
        if (with_bodies) start_part_of_bodies(alone, part.h, bdf.gamma);
        see_colliders(worker, cloth, part);
        if (k > 0 && air_is_on()) air_forces(worker, cloth, true);
        if (cloth.features) find_features(worker, *cloth.features, alone, part.h);
        StepEquation equation = equation_of(worker, cloth, part.h, bdf);
        begin_contacts(worker, cloth, part);
        if (cloth.features && cloth.solver->joins() && !has_zones(cloth.settings.self_collision)) {
            join_features(worker, *cloth.features, 0, cloth, equation);
            cloth.features->make_rows(worker.parallel, equation.gamma);
        }
        if (with_bodies) carry_bodies(cloth, equation);
        solve_equation(worker, cloth, equation, part.is_last() && is_residual_due(cloth));
        if (with_bodies) collect_from_equation(cloth, equation);
        if (reports_contacts() && equation.pairs != nullptr) {
            equation.pairs->take(worker.parallel, 0, std::as_const(cloth.next_velocities).span());
            find_missing_impulses({.parallel = worker.parallel,
                                   .profiler = profiler,
                                   .model = cloth.model,
                                   .settings = cloth.settings,
                                   .equation = equation,
                                   .velocities = cloth.next_velocities.span()},
                                  cloth);
        }
        advance(worker, cloth, equation, part.is_first());
        settle(worker, cloth, part);
        if (cloth.features) {
            settle_features(worker, *cloth.features, alone, part);
            cut_much |= was_cut_much(alone);
        }
        if (with_bodies) finish_part_of_bodies(alone);
    }
    count_halved_steps(alone, cut_much);
}

/// Since colliders are thin or fast.
int Simulation::parts_to_meet(Worker& worker, Cloth& cloth, const Substep& substep) {
    constexpr std::uint32_t most = 8;
    if (state.colliders.size() == 0 || !meets_in_equation(cloth.settings)) return 1;
    const auto timer = timed(Stage::colliders);
    see_colliders(worker, cloth, substep);
    return static_cast<int>(
        weft::parts_to_meet(worker.parallel, colliders_of(worker, cloth), side_of(cloth.settings), substep.h,
                            most, std::as_const(cloth.state.positions).span(),
                            std::as_const(cloth.state.velocities).span(), cloth.partial_counts.span()));
}

// What must hold exactly, the most important last: no particle inside a collider, none beyond its leash or in
// its backstop, none too fast.
void Simulation::settle(Worker& worker, Cloth& cloth, const Substep& part) {
    hold_within_limits(worker, cloth);
    avoid_self_collision(worker, cloth, part.h);
    collide_with_colliders(worker, cloth, part);
    hold_worn(worker, cloth);
    Cloth* const self = &cloth;
    place_attached({&self, 1});
    if (!cloth.limits.empty() || cloth.worn.is_holding() || cloth.self_counts.pairs > 0 ||
        cloth.collider_contacts > 0 || !cloth.attached.empty())
        limit_speeds(worker.parallel, settings.max_speed, cloth.state.velocities.span());
}

StepEquation Simulation::equation_of(Worker& worker, Cloth& cloth, float h, const Bdf& bdf) {
    const ClothState& now = cloth.state;
    const bool second_order = bdf.is_second_order();
    if (second_order) {
        const auto timer = timed(Stage::assemble);
        cloth.history->begin(worker.parallel, now, bdf.divisor);
    }
    return {.settings = cloth.settings,
            .h = h,
            .gamma = bdf.gamma,
            .rigidity = held_rigidity(cloth.settings.fabric, bdf.gamma, cloth.bending_per_area),
            .positions = now.positions.span(),
            .velocities = now.velocities.span(),
            .base_positions = second_order ? cloth.history->base_positions() : now.positions.span(),
            .base_velocities = second_order ? cloth.history->base_velocities() : now.velocities.span(),
            .external = {.gravity = to_vector(settings.gravity),
                         .air_damping = cloth.settings.air_damping,
                         .air = std::as_const(cloth.air.forces).span()},
            .contacts = cloth.contacts ? &*cloth.contacts : nullptr,
            .divisor = bdf.divisor};
}

// Of finite elements it takes a quarter of a step, so it is measured in one step of 32.
bool Simulation::is_residual_due(const Cloth& cloth) const {
    return !cloth.settings.finite_elements.enabled || state.steps % 32 == 1;
}

void Simulation::solve_equation(Worker& worker, Cloth& cloth, const StepEquation& equation,
                                bool wants_residual) {
    const SolveResult result = cloth.solver->solve({.parallel = worker.parallel,
                                                    .profiler = profiler,
                                                    .model = cloth.model,
                                                    .settings = cloth.stepped_settings(),
                                                    .equation = equation,
                                                    .velocities = cloth.next_velocities.span(),
                                                    .wants_residual = wants_residual});
    take_result(worker, cloth, equation, result, wants_residual);
}

void Simulation::take_result(Worker& worker, Cloth& cloth, const StepEquation& equation,
                             const SolveResult& result, bool has_residual) {
    if (cloth.contacts)
        cloth.contacts->finish(worker.parallel, equation, std::as_const(cloth.next_velocities).span());
    cloth.solver_failed |= !result.ok;
    cloth.unsolved |= result.unsolved;
    if (has_residual) cloth.residual = std::isfinite(result.residual) ? result.residual : 1.0f;
}

// The step's first substep writes the new positions over the previous ones and swaps the two, so that the
// start of the step stays behind for the renderer's blend and for guard().
void Simulation::advance(Worker& worker, Cloth& cloth, const StepEquation& equation, bool is_first) {
    const auto timer = timed(Stage::advance);
    ClothState& now = cloth.state;
    if (reports_contacts()) add_impulses_of_equation(worker, cloth, equation);
    if (!meets_in_equation(cloth.settings))
        cloth.collider_contacts = filter_velocities(
            worker.parallel, colliders_of(worker, cloth), cloth.settings.collider_mask, equation.h,
            now.positions.span(), cloth.next_velocities.span(), cloth.partial_counts.span());
    bounce(worker, cloth, equation);
    if (!is_first && !colliders_of(worker, cloth).empty()) keep_part_start(worker, cloth);
    weft::advance(worker.parallel, equation,
                  {.solved = std::as_const(cloth.next_velocities).span(),
                   .max_speed = settings.max_speed,
                   .velocities = now.velocities.span(),
                   .positions = (is_first ? now.previous_positions : now.positions).span(),
                   .record = cloth.history ? &now.record : nullptr});
    if (cloth.history && equation.pairs != nullptr) forget_contact(*equation.pairs, equation.first, now);
    if (is_first) std::swap(now.positions, now.previous_positions);
}

float Simulation::least_bounce(float h) const {
    return 2 * h * to_vector(settings.gravity).norm();
}

ClothSide Simulation::side_of_cloth(const Cloth& cloth, float h) const {
    ClothSide side = side_of(cloth.settings);
    side.least_bounce = least_bounce(h);
    return side;
}

void Simulation::bounce(Worker& worker, Cloth& cloth, const StepEquation& equation) const {
    if (!cloth.contacts || colliders_of(worker, cloth).empty()) return;
    cloth.contacts->bounce(worker.parallel, equation, least_bounce(equation.h), cloth.next_velocities.span());
}

void Simulation::keep_part_start(Worker& worker, Cloth& cloth) {
    const std::span<const Vec4> now = std::as_const(cloth.state.positions).span();
    worker.parallel.ranges(cloth.state.size(), [&](const BlockRange& range) {
        std::copy(now.begin() + range.begin, now.begin() + range.end, cloth.part_start.data() + range.begin);
    });
}

void Simulation::hold_within_limits(Worker& worker, Cloth& cloth) {
    for (const std::unique_ptr<Limit>& limit : cloth.limits) {
        const auto timer = timed(Stage::limits);
        limit->update(cloth.model);
        limit->hold(worker.parallel, cloth.settings, cloth.state.positions.span(),
                    cloth.state.velocities.span());
    }
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
    if (reports_contacts()) log_avoidance(worker, cloth, h);
    cloth.self_counts =
        cloth.self_contacts->respond(worker.parallel, distance, cloth.settings.self_collision.friction, h,
                                     cloth.state.positions.span(), cloth.state.velocities.span());
}

void Simulation::collide_with_colliders(Worker& worker, Cloth& cloth, const Substep& part) {
    if (!meets_in_equation(cloth.settings)) return;
    const AlignedBuffer<Vec4>& starts = part.is_first() ? cloth.state.previous_positions : cloth.part_start;
    cloth.collider_contacts = 0;
    if (colliders_of(worker, cloth).empty()) return;
    cloth.collider_contacts = collide(worker, cloth, part.h, starts.span());
    // Resting particles press in the equation alone, and need no push.
    if (cloth.contacts)
        cloth.collider_contacts = std::max(cloth.collider_contacts, cloth.contacts->pressing());
}

std::uint32_t Simulation::collide(Worker& worker, Cloth& cloth, float h, std::span<const Vec4> starts) {
    const auto timer = timed(Stage::colliders);
    if (cloth.meets_bodies) return collide_with_bodies(worker, cloth, h, starts);
    if (reports_contacts())
        std::ranges::copy(std::as_const(cloth.state.velocities).span(), cloth.next_velocities.data());
    const std::uint32_t touching =
        weft::collide(worker.parallel, colliders_of(worker, cloth), side_of_cloth(cloth, h), h,
                      {.positions = cloth.state.positions.span(),
                       .velocities = cloth.state.velocities.span(),
                       .starts = starts,
                       .held = cloth.state.held.normals.span(),
                       .factors = cloth.worn.factors(),
                       .whole = cloth.whole ? &*cloth.whole : nullptr},
                      cloth.partial_counts.span());
    if (reports_contacts() && touching > 0)
        add_impulses_of_change(worker, cloth, std::as_const(cloth.next_velocities).span());
    return touching;
}

std::span<const ColliderMotion> Simulation::colliders_in_equation(const Worker& worker, Cloth& cloth) {
    return meets_in_equation(cloth.settings) ? std::span<const ColliderMotion>(colliders_of(worker, cloth))
                                             : std::span<const ColliderMotion>();
}

// Neither rounding nor the speed limit may make a pin miss its target; only cloth in its way may. Whatever
// stage wrote a velocity last, max_speed is enforced here.
void Simulation::guard(Worker& worker, Cloth& cloth) {
    const auto timer = timed(Stage::guard);
    const auto look = [&] {
        if (!cloth.features) cloth.place_pins();
        return survey(worker.parallel, cloth.state, cloth.partial_surveys.span());
    };
    cloth.extent = look();
    cloth.restored = std::exchange(cloth.solver_failed, false) || !cloth.extent.sound;
    if (cloth.restored) cloth.restore_start_of_step();
    const bool is_too_fast = cloth.extent.peak_speed_squared > settings.max_speed * settings.max_speed;
    if (is_too_fast) limit_speeds(worker.parallel, settings.max_speed, cloth.state.velocities.span());
    if (cloth.restored || is_too_fast) cloth.extent = look();
    cloth.pin_lag = cloth.features && !cloth.restored ? cloth.farthest_pin() : 0;
}

void Simulation::finish(Worker& worker, Cloth& cloth) {
    if (reports_contacts()) find_touched_colliders(worker, cloth);
    end_worn(worker, cloth);
    const auto timer = timed(Stage::normals);
    update_normals(worker.parallel, cloth);
}

void Simulation::end(float dt) {
    for (Cloth* cloth : present_) {
        count_still_time(*cloth, dt);
        add_to_report(report_of(*cloth));
        const bool in_one_part = !cloth->history || cloth->state.record.h == dt;
        if (cloth->state.frame) arrive(*cloth->state.frame, dt, in_one_part, settings.max_speed);
    }
    report.cloths += report.sleeping_cloths;
    if (reports_contacts()) report_contacts();
    const Vec3& wind = settings.wind.velocity;
    const double seconds = static_cast<double>(dt);
    state.wind_path[0] += static_cast<double>(wind.x) * seconds;
    state.wind_path[1] += static_cast<double>(wind.y) * seconds;
    state.wind_path[2] += static_cast<double>(wind.z) * seconds;
    state.time += seconds;
    state.colliders.for_each([](ColliderId, ColliderSlot& slot) { slot.current = slot.target; });
    profiler.end_step();
    report.milliseconds = profiler.last_step_ms();
    if (settings.budget > 0) learn_costs();
}

}  // namespace weft
