// Transport of cloths by their frames; motions of colliders and of worn limits over a substep.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cloth/mesh/coordinates.h"
#include "cloth/stages/step_bodies.h"
#include "cloth/stages/worn_step.h"
#include "collision/shapes/moving_shapes.h"

namespace weft {

namespace {

/// Whether rounding, at the cloth's distance from the origin, can close the least gap of features.
bool rounds_gaps_away(const Cloth& cloth) {
    const Vec3 &lower = cloth.extent.lower, &upper = cloth.extent.upper;
    const float farthest = std::max({-lower.x, -lower.y, -lower.z, upper.x, upper.y, upper.z});
    constexpr float step = 0x1p-22f;
    return step * farthest > 0.125f * cloth.as_body().floor;
}

/// Box around the cloth before and after a motion.
Eigen::AlignedBox3d box_over(const Cloth& cloth, const RigidMotion& by) {
    const Eigen::AlignedBox3d here(to_vector(cloth.extent.lower).cast<double>(),
                                   to_vector(cloth.extent.upper).cast<double>());
    Eigen::AlignedBox3d box = here;
    if (here.isEmpty()) return box;
    for (int corner = 0; corner < 8; ++corner)
        box.extend(by.turn * here.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)) + by.shift);
    return box;
}

/// Box around the cloth before and after its transport.
Eigen::AlignedBox3d box_over_carry(const Cloth& cloth) {
    return box_over(cloth, cloth.carried ? cloth.carried->by : RigidMotion{});
}

bool stays_within_reach(const Eigen::AlignedBox3d& box) {
    return box.isEmpty() ||
           box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff() <= double{runaway_distance};
}

/// Whether transport may move features of one cloth across those of the other.
bool may_be_carried_across(const Cloth& a, const Cloth& b) {
    const auto reach = static_cast<double>(a.as_body().radius + b.as_body().radius);
    return box_over_carry(a).exteriorDistance(box_over_carry(b)) <= reach;
}

bool are_carried_alike(const Cloth& a, const Cloth& b) {
    if (a.carried.has_value() != b.carried.has_value()) return false;
    return !a.carried ||
           (a.carried->by.turn == b.carried->by.turn && a.carried->by.shift == b.carried->by.shift);
}

/// Teleports a cloth whose frame jumps.
void jump_with_frame(Simulation& world, Cloth& cloth, float dt) {
    cloth.jumped =
        jump_of(*cloth.state.frame, cloth.settings.teleport_distance, cloth.settings.teleport_angle, dt);
    if (!cloth.jumped) return;
    if (!stays_within_reach(box_over(cloth, *cloth.jumped))) {
        cloth.jumped.reset();
        cloth.solver_failed = true;  // guard() stops it where it is
        return;
    }
    jump(world.parallel, *cloth.jumped, cloth.state);
    world.has_been_moved(cloth);
}

/// The greatest way of a collider's points [m]; negative for planes.
float greatest_way(const ColliderMotion& motion) {
    constexpr Pace any_pace{1, std::numeric_limits<float>::infinity()};
    return with_shapes(
        motion, [&](const auto& start, const auto& end) { return sweeping(start, end, any_pace, 0).way; });
}

/// Where a collider starts, as a cloth sees it that may have jumped: a limb jumps with it, a wall does not.
Collider start_of(const ColliderSlot& slot, const Cloth* cloth, ColliderMotion motion) {
    if (cloth == nullptr || !cloth->jumped) return slot.current;
    const Collider jumped = moved(slot.current, *cloth->jumped);
    const float way = greatest_way(motion);
    motion.start = jumped;
    return greatest_way(motion) < way ? jumped : slot.current;
}

bool is_moved(const Cloth& cloth) {
    return cloth.carried && cloth.carried->moves;
}

}  // namespace

void fill_motions(const Simulation& world, std::vector<ColliderMotion>& motions, std::uint32_t mask,
                  const Substep& substep, const Cloth* cloth) {
    motions.clear();
    world.state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
        if (slot.target.is_trigger || (slot.target.layers & mask) == 0) return;
        if (world.body_stage && world.state.bodies.find(slot.body) != nullptr) return;
        ColliderMotion& motion =
            motions.emplace_back(ColliderMotion{slot.current, slot.target, world.settings.max_speed});
        motion.held = world.held_by(slot.target);
        Collider from = start_of(slot, cloth, motion);
        if (cloth != nullptr && is_moved(*cloth)) from = moved(from, cloth->carried->by);
        motion.start = from;
        // A collider that jumps is at its target from the first substep on: half way it would hit cloth that
        // lies there.
        if (!has_jumped(motion, substep.h * static_cast<float>(substep.count))) {
            motion.start = blend(from, slot.target, substep.begin());
            motion.end = blend(from, slot.target, substep.end());
        } else if (!substep.is_first()) {
            motion.start = slot.target;
        }
        if (motion.held != nullptr && motion.held->deforms_in(world.state.steps))
            motion.rate = 1 / (substep.h * static_cast<float>(substep.count));
        motion.filled = filled_by(motion);
    });
}

// Cloth that is transported across another, or so far from the origin that rounding can make features cross,
// may cross something afterwards.
void plan_carries(Simulation& world, float dt) {
    bool any = false;
    for (Cloth* cloth : world.present) {
        cloth->carried.reset();
        cloth->jumped.reset();
        cloth->acting = {};
        if (!cloth->state.frame) continue;
        jump_with_frame(world, *cloth, dt);
        if (cloth->settings.max_speed_in_frame > 0)
            cloth->acting = acting_motion(*cloth->state.frame, cloth->settings.frame_inertia, dt);
        cloth->carried = carry_of(*cloth->state.frame, cloth->settings.frame_inertia, dt);
        if (!is_moved(*cloth)) continue;
        any = true;
        if (stays_within_reach(box_over_carry(*cloth))) continue;
        cloth->carried.reset();
        cloth->solver_failed = true;  // guard() stops it where it is
    }
    if (!any) return;
    for (Cloth* cloth : world.present)
        if (is_moved(*cloth) && cloth->has_features() && rounds_gaps_away(*cloth)) cloth->state.may_cross = 1;
    if (world.featured_cloths < 2) return;
    for (Cloth* cloth : world.present) {
        if (!is_moved(*cloth) || !cloth->has_features()) continue;
        for (const Cloth* other : world.present)
            if (other != cloth && other->has_features() && !are_carried_alike(*cloth, *other) &&
                may_be_carried_across(*cloth, *other))
                cloth->state.may_cross = 1;
    }
}

/// Updates the motions of colliders that a set's cloths may meet, and the own lists of transported cloths.
void see_colliders(const Simulation& world, Worker& worker, std::span<Cloth* const> set,
                   const Substep& substep) {
    std::uint32_t mask = 0;
    bool with_bodies = false;
    for (const Cloth* cloth : set) {
        mask |= cloth->settings.collider_mask;
        with_bodies = with_bodies || cloth->meets_bodies;
    }
    if (worker.seen_layers != mask || worker.seen_over != substep)
        fill_motions(world, worker.motions, mask, substep, nullptr);
    worker.seen_layers = mask;
    worker.seen_over = substep;
    for (Cloth* cloth : set)
        if (cloth->sees_own_colliders())
            fill_motions(world, cloth->seen_colliders, cloth->settings.collider_mask, substep, cloth);
    if (!with_bodies) return;
    add_carried_motions(world, colliders_of(worker, *set.front()), mask, substep);
    worker.seen_over = {0, 0, 0};
}

void begin_contacts(const Worker& worker, Cloth& cloth, const ClothSide& side, const Substep& part) {
    const bool has_own = cloth.worn.has_limits();
    if (has_own) cloth.worn.begin(cloth.state.skin, part.end(), part.h * static_cast<float>(part.count));
    if (!cloth.contacts) return;
    cloth.contacts->begin(colliders_in_equation(worker, cloth), side, cloth.state.held,
                          has_own ? &cloth.worn : nullptr);
}

void hold_worn(Simulation& world, Worker& worker, Cloth& cloth) {
    if (!cloth.worn.is_holding()) return;
    const auto timer = world.timed(Stage::limits);
    cloth.worn.hold(worker.parallel, cloth.state.positions.span(), cloth.state.velocities.span());
}

/// After the step: measures by how much worn limits gave way, and moves the skin to its targets.
void end_worn(Worker& worker, Cloth& cloth) {
    cloth.limit_lag = {};
    if (cloth.worn.is_holding() && cloth.has_features() && !cloth.restored)
        cloth.limit_lag = cloth.worn.lag(worker.parallel, std::as_const(cloth.state.positions).span());
    SkinState& skin = cloth.state.skin;
    if (skin.known != 0) skin.stand_still();
    if (cloth.carried) leave_start_behind(worker.parallel, *cloth.carried, cloth.state);
}

void Simulation::set_frame(Cloth& cloth, const Transform& pose) {
    if (!cloth.state.frame) {
        cloth.seen_colliders.reserve(state.colliders.size());
        cloth.state.frame = FrameState{.pose = pose, .target = pose};
    }
    cloth.state.frame->target = pose;
}

void Simulation::move(Cloth& cloth, const RigidMotion& by) {
    move_all(parallel, by, cloth.state);
    has_been_moved(cloth);
}

void Simulation::has_been_moved(Cloth& cloth) {
    cloth.state.may_cross = cloth.has_features() ? 1 : 0;
    // A step begins with the triangles' normals that the last one ended with.
    update_normals(parallel, cloth);
    cloth.extent = survey(parallel, cloth.state, cloth.partial_surveys.span());
}

}  // namespace weft
