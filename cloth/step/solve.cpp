// The solve of a substep: the equations of each group of cloths, in as many parts as the group needs.

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "cloth/motion/advance.h"
#include "cloth/solver/passes/multilevel.h"
#include "cloth/stages/collide_step.h"
#include "cloth/stages/contact_step.h"
#include "cloth/stages/forces/air_step.h"
#include "cloth/stages/forces/filling_step.h"
#include "cloth/stages/forces/seam_step.h"
#include "cloth/stages/report_contacts.h"
#include "cloth/stages/step_bodies.h"
#include "cloth/stages/worn_step.h"
#include "cloth/step/solve.h"
#include "collision/particles/velocity_filter.h"

namespace weft {

namespace {

bool any_meets_bodies(std::span<Cloth* const> cloths) {
    return std::ranges::any_of(cloths, &Cloth::meets_bodies);
}

/// The gamma of one equation for all of these cloths: the largest of theirs.
float common_gamma(std::span<Cloth* const> cloths, float h) {
    float most = 0;
    for (const Cloth* cloth : cloths) most = std::max(most, cloth->bdf_of(h).gamma);
    return most;
}

// Where layers approach by many contact radii in a step, their pairs overflow the list, and the cut leaves
// knots. Half the motion has half as many pairs.
bool was_cut_much(std::span<Cloth* const> featured) {
    if (featured.empty()) return false;
    constexpr std::uint32_t most = 400;  // one particle in so many may have been cut
    std::uint32_t particles = 0;
    for (const Cloth* cloth : featured) particles += cloth->state.size();
    const FeatureCounts& counts = featured.front()->feature_counts;
    if (counts.unresolved > 0) return false;  // zones cut nothing
    // Half steps would push crossing cloth apart twice, and it would fly.
    const bool is_tangled = counts.tangles.crossings > 0;
    return counts.overflowed || (!is_tangled && most * counts.truncated > particles);
}

void count_halved_steps(std::span<Cloth* const> featured, bool cut_much) {
    for (Cloth* cloth : featured) {
        std::uint32_t& halved = cloth->state.halved;
        halved = cut_much ? ClothState::most_halved : halved - std::min(halved, 1u);
    }
}

/// The parts that a substep needs so that no thin or fast collider is passed.
int parts_to_meet(Simulation& world, Worker& worker, Cloth& cloth, const Substep& substep) {
    constexpr std::uint32_t most = 8;
    if (world.state.colliders.size() == 0 || !meets_in_equation(cloth.settings)) return 1;
    const auto timer = world.timed(Stage::colliders);
    Cloth* const self = &cloth;
    see_colliders(world, worker, {&self, 1}, substep);
    return static_cast<int>(weft::parts_to_meet(worker.parallel, colliders_of(worker, cloth), cloth.side(),
                                                substep.h, most, std::as_const(cloth.state.positions).span(),
                                                std::as_const(cloth.state.velocities).span(),
                                                cloth.partial_counts.span()));
}

int parts_of(Simulation& world, Worker& worker, std::span<Cloth* const> cloths, const Substep& substep) {
    int substeps = 1, parts = 1;
    for (Cloth* cloth : cloths) {
        substeps = std::max(substeps, cloth->settings.substeps);
        parts =
            std::max({parts, cloth->state.halved > 0 ? 2 : 1, parts_to_meet(world, worker, *cloth, substep)});
    }
    return substeps * parts;
}

/// The places among a group's cloths where its sets of one and its set of first order end.
struct SetEnds {
    std::size_t alone, first_order;
};

/// Orders a group's cloths by sets: first each cloth that cannot share an equation, as a set of one; then the
/// set of those whose step is first order, and the set of those whose step is second order, if not empty.
SetEnds order_by_sets(const Simulation& world, Group& group, std::span<Cloth* const> cloths, float h) {
    // Bodies move the colliders of one list, and a transported cloth has a list of its own.
    const auto is_alone = [&](const Cloth& cloth) {
        return !cloth.can_join() || (world.body_stage && cloth.sees_own_colliders());
    };
    std::size_t end = 0;
    const auto add = [&](const auto& is_wanted) {
        for (Cloth* cloth : cloths)
            if (is_wanted(*cloth)) group.cloths[end++] = cloth;
        return end;
    };
    const auto is_second_order = [&](const Cloth& cloth) { return cloth.bdf_of(h).is_second_order(); };
    SetEnds ends{};
    ends.alone = add(is_alone);
    ends.first_order = add([&](const Cloth& cloth) { return !is_alone(cloth) && !is_second_order(cloth); });
    add([&](const Cloth& cloth) { return !is_alone(cloth) && is_second_order(cloth); });
    return ends;
}

StepEquation equation_of(Simulation& world, Worker& worker, Cloth& cloth, float h, const Bdf& bdf) {
    const ClothState& now = cloth.state;
    const bool second_order = bdf.is_second_order();
    if (second_order) {
        const auto timer = world.timed(Stage::assemble);
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
            .external = {.gravity = world.gravity_on(cloth),
                         .air_damping = cloth.settings.air_damping,
                         .air = std::as_const(cloth.air.forces).span(),
                         .filling = cloth.filling ? &*cloth.filling : nullptr},
            .contacts = cloth.contacts ? &*cloth.contacts : nullptr,
            .divisor = bdf.divisor};
}

// The residual of finite elements takes a quarter of a step, so it is measured in one step of 32.
bool is_residual_due(const Simulation& world, const Cloth& cloth) {
    return !cloth.settings.finite_elements.enabled || world.state.steps % 32 == 1;
}

void make_equations(Simulation& world, Worker& worker, Group& group, std::span<Cloth* const> set,
                    const Substep& part, float gamma) {
    const auto first = static_cast<std::size_t>(set.data() - group.cloths.data());
    const std::span<Cloth* const> featured = group.all_featured();
    bool any_pairs = false;
    std::uint32_t next = group.contact.particles();
    for (std::size_t m = first; m < first + set.size(); ++m) {
        Cloth& cloth = *group.cloths[m];
        StepEquation& equation = *std::construct_at(
            &group.equations[m], equation_of(world, worker, cloth, part.h, cloth.bdf_of(part.h, gamma)));
        begin_contacts(worker, cloth, side_of(world, cloth, part.h), part);
        begin_filling(worker, cloth, equation);
        const bool has_pairs = cloth.has_features() && cloth.can_join();
        if (has_pairs) {
            const auto body =
                static_cast<std::size_t>(std::ranges::find(featured, &cloth) - featured.begin());
            group.contact.set_base(worker.parallel, body, equation.base_positions);
            equation.pairs = &group.contact.rows();
            equation.first = group.contact.first(body);
            any_pairs = true;
        } else if (!cloth.seams.empty()) {
            equation.first = next;
            next += Stencil::whole_groups(cloth.model.particle_count);
        }
        equation.seams = cloth.seams;
        if (has_pairs || !cloth.seams.empty())
            cloth.contacts->join(equation.pairs, equation.seams, equation.first);
        cloth.equation = &equation;
        if (cloth.meets_bodies) carry_bodies(world, cloth, equation);
        std::construct_at(&group.steps[m],
                          SolverStep{.parallel = worker.parallel,
                                     .profiler = world.profiler,
                                     .model = cloth.model,
                                     .settings = cloth.stepped_settings(),
                                     .equation = equation,
                                     .air = air_force(world, cloth),
                                     .velocities = cloth.scratch_velocities.span(),
                                     .wants_residual = part.is_last() && is_residual_due(world, cloth)});
        if (cloth.can_join())
            std::construct_at(
                &group.members[m],
                static_cast<MultilevelSolver&>(*cloth.solver).member(group.steps[m], cloth.sewn));
    }
    begin_seams(world, set, gamma);
    if (!any_pairs) return;
    for (std::size_t k = 0; k < featured.size(); ++k)
        if (std::ranges::find(set, featured[k]) == set.end())
            group.contact.set_fixed_base(worker.parallel, k, featured[k]->state.positions.span());
    group.contact.make_rows(worker.parallel, gamma);
}

void hold_within_limits(Simulation& world, Worker& worker, Cloth& cloth) {
    for (const std::unique_ptr<Limit>& limit : cloth.limits) {
        const auto timer = world.timed(Stage::limits);
        limit->update(cloth.model);
        limit->hold(worker.parallel, cloth.settings, cloth.state.positions.span(),
                    cloth.state.velocities.span());
    }
}

void avoid_self_collision(Simulation& world, Worker& worker, Cloth& cloth, float h) {
    if (!cloth.self_contacts) return;
    const float distance = cloth.rest_neighbours->distance();
    {
        const auto timer = world.timed(Stage::self_search);
        cloth.self_contacts->find(worker.parallel, cloth.state.positions.span(),
                                  cloth.rest_neighbours->filter(), distance,
                                  *search_of(cloth.settings.self_collision.method));
    }
    const auto timer = world.timed(Stage::self_response);
    if (world.reports_contacts()) log_avoidance(worker, cloth, h);
    cloth.self_counts =
        cloth.self_contacts->respond(worker.parallel, distance, cloth.settings.self_collision.friction, h,
                                     cloth.state.positions.span(), cloth.state.velocities.span());
}

void collide_with_colliders(Simulation& world, Worker& worker, Cloth& cloth, const Substep& part) {
    if (!meets_in_equation(cloth.settings)) return;
    const AlignedBuffer<Vec4>& starts = part.is_first() ? cloth.state.previous_positions : cloth.part_start;
    cloth.collider_contacts = 0;
    if (colliders_of(worker, cloth).empty()) return;
    cloth.collider_contacts = collide(world, worker, cloth, part.h, starts.span());
    // Resting particles press in the equation alone, and need no push.
    if (cloth.contacts)
        cloth.collider_contacts = std::max(cloth.collider_contacts, cloth.contacts->pressing());
}

// Each stage overrides those before it, so the most important is last: springs' limits, other cloth,
// colliders, the volume that they took, leashes and backstops.
void settle(Simulation& world, Worker& worker, Cloth& cloth, const Substep& part) {
    hold_within_limits(world, worker, cloth);
    avoid_self_collision(world, worker, cloth, part.h);
    collide_with_colliders(world, worker, cloth, part);
    restore_volume(worker, cloth);
    hold_worn(world, worker, cloth);
}

void take_result(Worker& worker, Cloth& cloth, const StepEquation& equation, const SolveResult& result,
                 bool has_residual) {
    if (cloth.contacts)
        cloth.contacts->finish(worker.parallel, equation, std::as_const(cloth.scratch_velocities).span());
    cloth.solver_failed |= !result.ok;
    cloth.unsolved |= result.unsolved;
    if (has_residual) cloth.residual = std::isfinite(result.residual) ? result.residual : 1.0f;
}

void bounce(Worker& worker, Cloth& cloth, const StepEquation& equation) {
    if (!cloth.contacts || colliders_of(worker, cloth).empty()) return;
    cloth.contacts->bounce(worker.parallel, equation, cloth.scratch_velocities.span());
}

void keep_part_start(Worker& worker, Cloth& cloth) {
    const std::span<const Vec4> now = std::as_const(cloth.state.positions).span();
    worker.parallel.ranges(cloth.state.size(), [&](const BlockRange& range) {
        std::copy(now.begin() + range.begin, now.begin() + range.end, cloth.part_start.data() + range.begin);
    });
}

// The step's first substep writes the new positions over the previous ones and swaps the two, so that the
// start of the step stays behind for the renderer's blend and for guard().
void advance(Simulation& world, Worker& worker, Cloth& cloth, const StepEquation& equation, bool is_first) {
    const auto timer = world.timed(Stage::advance);
    ClothState& now = cloth.state;
    if (world.reports_contacts()) add_impulses_of_equation(worker, cloth, equation);
    if (!meets_in_equation(cloth.settings))
        cloth.collider_contacts = filter_velocities(
            worker.parallel, colliders_of(worker, cloth), cloth.side(), equation.h, now.positions.span(),
            cloth.scratch_velocities.span(), cloth.partial_counts.span());
    bounce(worker, cloth, equation);
    if (cloth.settings.max_speed_in_frame > 0)
        limit_speeds(worker.parallel, cloth.acting, cloth.settings.max_speed_in_frame, now.positions.span(),
                     cloth.scratch_velocities.span());
    if (!is_first && !colliders_of(worker, cloth).empty()) keep_part_start(worker, cloth);
    weft::advance(worker.parallel, equation,
                  {.solved = std::as_const(cloth.scratch_velocities).span(),
                   .max_speed = world.settings.max_speed,
                   .velocities = now.velocities.span(),
                   .positions = (is_first ? now.previous_positions : now.positions).span(),
                   .record = cloth.history ? &now.record : nullptr});
    if (cloth.history && equation.pairs != nullptr) forget_contact(*equation.pairs, equation.first, now);
    if (is_first) std::swap(now.positions, now.previous_positions);
}

/// Solves cloths as one equation and moves them.
void solve_set(Simulation& world, Worker& worker, Group& group, std::span<Cloth* const> set,
               const Substep& part) {
    const bool with_bodies = any_meets_bodies(set);
    const float gamma = common_gamma(set, part.h);
    if (with_bodies) {
        for (Cloth* cloth : set) cloth->meets_bodies = true;
        start_part_of_bodies(world, set, part, gamma);
    }
    see_colliders(world, worker, set, part);
    make_equations(world, worker, group, set, part, gamma);
    const auto first = static_cast<std::size_t>(set.data() - group.cloths.data());
    const auto of_set = [&](auto& array) { return array.span().subspan(first, set.size()); };
    const std::span<StepEquation> equations = of_set(group.equations);
    const std::span<float> residuals = of_set(group.residuals);
    SolveResult result;
    if (set.front()->can_join()) {
        result = solve_by_passes(of_set(group.members), residuals);
    } else {
        result = set.front()->solver->solve(group.steps[first]);
        residuals.front() = result.residual;
    }
    for (std::size_t m = 0; m < set.size(); ++m) {
        take_result(worker, *set[m], equations[m], {residuals[m], result.ok, result.unsolved},
                    group.steps[first + m].wants_residual);
        if (with_bodies) collect_from_equation(world, *set[m], equations[m]);
    }
    if (with_bodies) keep_momentum_of_bodies(world, set, equations);
    end_seams(world, set);
    for (std::size_t m = 0; m < set.size() && world.reports_contacts(); ++m) {
        if (equations[m].pairs == nullptr) continue;
        equations[m].pairs->take(worker.parallel, equations[m].first,
                                 std::as_const(set[m]->scratch_velocities).span());
        find_missing_impulses(group.steps[first + m], *set[m]);
    }
    for (Cloth* cloth : set) cloth->equation = nullptr;
    for (std::size_t m = 0; m < set.size(); ++m) {
        advance(world, worker, *set[m], equations[m], part.is_first());
        settle(world, worker, *set[m], part);
    }
    place_attached(world, set);
    for (Cloth* cloth : set)
        if (!cloth->limits.empty() || cloth->worn.is_holding() || cloth->self_counts.pairs > 0 ||
            cloth->collider_contacts > 0 || !cloth->attached.empty())
            limit_speeds(worker.parallel, world.settings.max_speed, cloth->state.velocities.span());
}

// Sets are solved and moved one after the other; in a set's equation all other cloths are fixed where they
// then are. Impulses on bodies from the end of contact are passed on with the last set's.
void solve_part(Simulation& world, Worker& worker, Group& group, Scratch scratch,
                std::span<Cloth* const> cloths, const Substep& part) {
    const std::span<Cloth* const> featured = group.all_featured();
    if (!featured.empty()) {
        group.contact = {};
        group.contact.lay_out(scratch, group.all_bodies(), world.zones.get());
        find_features(world, worker, group.contact, featured, part.h);
    }
    agree_on_order(cloths, part.h);
    const SetEnds ends = order_by_sets(world, group, cloths, part.h);
    std::span<Cloth* const> set;
    for (std::size_t begin = 0, end; begin < cloths.size(); begin = end) {
        if (any_meets_bodies(set)) finish_part_of_bodies(world, set);
        end = begin < ends.alone ? begin + 1 : begin < ends.first_order ? ends.first_order : cloths.size();
        set = std::as_const(group.cloths).span().subspan(begin, end - begin);
        solve_set(world, worker, group, set, part);
    }
    if (!featured.empty()) settle_features(world, worker, group.contact, featured, part);
    if (any_meets_bodies(set)) finish_part_of_bodies(world, set);
    if (any_meets_bodies(cloths)) end_part_of_bodies(world, cloths);
}

}  // namespace

// All cloths of a group take as many parts as the one that needs most, so that they touch at the same time.
void solve(Simulation& world, Worker& worker, std::span<Cloth* const> cloths, float dt,
           const Substep& substep) {
    Scratch scratch(worker.scratch);
    Group group;
    group.lay_out(scratch, cloths.size());
    for (Cloth* cloth : cloths) cloth->lay_out(scratch);
    group.add_featured(cloths);
    const bool with_bodies = any_meets_bodies(cloths);
    if (with_bodies) take_bodies(world, cloths, substep);
    const int parts = parts_of(world, worker, cloths, substep);
    bool cut_much = false;
    for (int k = 0; k < parts; ++k) {
        if (k > 0 && world.air_is_on())
            for (Cloth* cloth : cloths) find_air_forces(world, worker, *cloth, false);
        solve_part(world, worker, group, scratch, cloths, substep.part(k, parts, dt));
        cut_much |= was_cut_much(group.all_featured());
    }
    if (with_bodies) leave_bodies(world, cloths);
    count_halved_steps(group.all_featured(), cut_much);
}

}  // namespace weft
