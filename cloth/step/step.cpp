// A World's step.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "cloth/stages/contact_step.h"
#include "cloth/stages/forces/seam_step.h"
#include "cloth/stages/report_contacts.h"
#include "cloth/stages/step_bodies.h"
#include "cloth/stages/worn_step.h"
#include "cloth/step/choose.h"
#include "cloth/step/cloth_step.h"
#include "cloth/step/sleep.h"
#include "cloth/step/solve.h"
#include "cloth/step/step_report.h"

namespace weft {

namespace {

void begin(Simulation& world, float dt) {
    world.profiler.begin_step();
    world.report = {.step = ++world.state.steps, .substeps = world.settings.substeps};
    world.contact_reports.clear();
    for (const std::unique_ptr<SeamRows>& seam : world.seam_rows)
        if (seam) seam->begin_step();
    choose_present(world, dt);
    if (world.settings.budget > 0) choose_details(world);
    world.cloths.for_each([](ClothId, std::unique_ptr<Cloth>& cloth) { cloth->was_stepped = false; });
    for (Cloth* cloth : world.present) {
        cloth->was_stepped = true;
        cloth->nanoseconds = 0;
        cloth->unsolved = false;
        cloth->pins_limited = false;
        cloth->contact_count = 0;
    }
    world.featured_cloths = static_cast<std::size_t>(
        std::ranges::count_if(world.present, [](const Cloth* cloth) { return cloth->has_features(); }));
    plan_carries(world, dt);
    world.each_cloth.plan(world.present, world.parallel.width());
}

void share_out_time(const Schedule::Group& group, std::int64_t nanoseconds) {
    std::int64_t particles = 0;
    for (const Cloth* cloth : group.cloths) particles += cloth->model.particle_count;
    for (Cloth* cloth : group.cloths)
        cloth->nanoseconds +=
            nanoseconds * cloth->model.particle_count / std::max<std::int64_t>(particles, 1);
}

// Groups for one thread come first: the k-th thread begins with the k-th group, and goes on with the next
// that is left. Then all threads work on one large group after the other. No parallel loop runs within
// another.
template <class Work>
void for_each_group(Simulation& world, const Schedule& schedule, const Work& work) {
    const auto take = [&](Worker& worker, const Schedule::Group& group) {
        const auto timer = world.timed(Stage::cloths);
        const std::int64_t begin = world.clock();
        work(worker, group.cloths);
        share_out_time(group, world.clock() - begin);
    };
    const std::span<const Schedule::Group> small = schedule.side_by_side();
    const std::size_t threads = std::min(world.motions.size(), small.size());
    std::atomic<std::size_t> next = threads;
    world.parallel.blocks(static_cast<std::uint32_t>(threads), [&](std::uint32_t thread) {
        Worker worker{world.serial, world.motions[thread], world.contact_reports.of_thread(thread),
                      world.scratch.data() + small[thread].scratch};
        for (std::size_t i = thread; i < small.size(); i = next.fetch_add(1)) take(worker, small[i]);
    });
    Worker all{world.parallel, world.motions[0], world.contact_reports.of_thread(0), world.scratch.data()};
    for (const Schedule::Group& group : schedule.in_turn()) take(all, group);
}

template <class Work>
void for_each_cloth(Simulation& world, const Work& work) {
    for_each_group(world, world.each_cloth,
                   [&](Worker& worker, std::span<Cloth* const> one) { work(worker, *one.front()); });
}

// Each phase spans the World, so that cloths that touch are solved together.
void step_together(Simulation& world, float dt) {
    for (int s = 0; s < world.settings.substeps; ++s) {
        const Substep substep = Substep{0, 1, dt}.part(s, world.settings.substeps, dt);
        begin_bodies(world, substep);
        for_each_cloth(world, [&](Worker& worker, Cloth& cloth) {
            if (!cloth.is_gliding())
                predict(world, worker, cloth, cloth.stride() * dt, substep.times(cloth.stride()));
            expect(world, cloth, substep.h);
        });
        meet(world);
        for_each_group(world, world.groups, [&](Worker& worker, std::span<Cloth* const> group) {
            const Cloth& first = *group.front();  // cloths that may touch take no long steps
            if (!first.is_gliding())
                solve(world, worker, group, first.stride() * dt, substep.times(first.stride()));
        });
        end_bodies(world, substep);
    }
    for_each_cloth(world, [&](Worker& worker, Cloth& cloth) { arrive(world, worker, cloth); });
}

// Cloths that cannot meet need not wait for one another: each takes all phases of all substeps while it is in
// the cache. A hundred flags lose a third of their time otherwise.
void step_each(Simulation& world, float dt) {
    for_each_cloth(world, [&](Worker& worker, Cloth& cloth) {
        const float own = cloth.stride() * dt;
        Cloth* const self = &cloth;
        for (int s = 0; s < world.settings.substeps && !cloth.is_gliding(); ++s) {
            const Substep substep = Substep{0, 1, own}.part(s, world.settings.substeps, own);
            predict(world, worker, cloth, own, substep);
            solve(world, worker, {&self, 1}, own, substep);
        }
        arrive(world, worker, cloth);
    });
}

void end(Simulation& world, float dt) {
    for (Cloth* cloth : world.present) {
        count_still_time(*cloth, dt);
        add_to_report(world.report, world.report_of(*cloth));
        const bool in_one_part = !cloth->history || cloth->state.record.h == dt;
        if (cloth->state.frame) arrive(*cloth->state.frame, dt, in_one_part, world.settings.max_speed);
    }
    world.report.cloths += world.report.sleeping_cloths;
    for (const std::unique_ptr<SeamRows>& seam : world.seam_rows)
        if (seam) world.report.broken_stitches += seam->broken();
    if (world.reports_contacts()) report_contacts(world);
    const Vec3& wind = world.settings.wind.velocity;
    const double seconds = static_cast<double>(dt);
    world.state.wind_path[0] += static_cast<double>(wind.x) * seconds;
    world.state.wind_path[1] += static_cast<double>(wind.y) * seconds;
    world.state.wind_path[2] += static_cast<double>(wind.z) * seconds;
    world.state.time += seconds;
    world.state.colliders.for_each([](ColliderId, ColliderSlot& slot) { slot.current = slot.target; });
    world.profiler.end_step();
    world.report.milliseconds = world.profiler.last_step_ms();
    if (world.settings.budget > 0) learn_costs(world);
}

}  // namespace

void Simulation::step(float dt) {
    begin(*this, dt);
    if (featured_cloths > 1 || body_stage || joins_cloths(*this))
        step_together(*this, dt);
    else
        step_each(*this, dt);
    end(*this, dt);
}

}  // namespace weft
