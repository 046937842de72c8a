// The frame: how a World steps, and the phases that each step names.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "cloth/frame/advance/advance.h"
#include "cloth/frame/simulation.h"

namespace weft {

namespace {

Vector3 limited(const Vector3& velocity, float max_speed) {
    const float squared = velocity.squaredNorm();
    return squared > max_speed * max_speed ? Vector3(velocity * (max_speed / std::sqrt(squared))) : velocity;
}

}  // namespace

void Simulation::step(float dt) {
    begin(dt);
    if (featured_cloths_ > 1 || bodies_)
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
            expect(cloth, substep.h);
        });
        meet();
        for_each_group(islands_, [&](Worker& worker, std::span<Cloth* const> island) {
            const Cloth& first = *island.front();  // cloths that may touch take no long steps
            if (!first.is_gliding())
                solve(worker, island, first.stride() * dt, substep.times(first.stride()));
        });
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
        Cloth* const self = &cloth;
        for (int s = 0; s < settings.substeps; ++s) {
            const Substep substep = Substep{0, 1, own}.part(s, settings.substeps, own);
            predict(worker, cloth, own, substep);
            solve(worker, {&self, 1}, own, substep);
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
        worker.scratch = scratch_.data() + group.scratch;
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
    featured_cloths_ = static_cast<std::size_t>(
        std::ranges::count_if(present_, [](const Cloth* cloth) { return cloth->has_features(); }));
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

// Neither rounding nor the speed limit may make a pin miss its target; only cloth in its way may. Whatever
// stage wrote a velocity last, max_speed is enforced here.
void Simulation::guard(Worker& worker, Cloth& cloth) {
    const auto timer = timed(Stage::guard);
    const auto look = [&] {
        if (!cloth.has_features()) cloth.place_pins();
        return survey(worker.parallel, cloth.state, cloth.partial_surveys.span());
    };
    cloth.extent = look();
    cloth.restored = std::exchange(cloth.solver_failed, false) || !cloth.extent.sound;
    if (cloth.restored) cloth.restore_start_of_step();
    const bool is_too_fast = cloth.extent.peak_speed_squared > settings.max_speed * settings.max_speed;
    if (is_too_fast) limit_speeds(worker.parallel, settings.max_speed, cloth.state.velocities.span());
    if (cloth.restored || is_too_fast) cloth.extent = look();
    cloth.pin_lag = cloth.has_features() && !cloth.restored ? cloth.farthest_pin() : 0;
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
