// Contact of features in a step: groups of cloths that may touch, detection, and the cut of their motion, so
// that nothing crosses anew.

#include <algorithm>
#include <limits>
#include <utility>

#include "cloth/contact/own_space.h"
#include "cloth/motion/advance.h"
#include "cloth/stages/collide_step.h"
#include "cloth/stages/contact_step.h"
#include "cloth/stages/forces/seam_step.h"
#include "cloth/stages/report_contacts.h"
#include "cloth/stages/worn_step.h"
#include "collision/search/patch_kernels.h"
#include "collision/shapes/moving_shapes.h"
#include "engine/bounds.h"

namespace weft {

namespace {

/// Axis-aligned bounding box of points. Coordinates that are NaN do not count.
class GrowingBox {
  public:
    void add(const Vector3& point) {
        lower_ = lower_.cwiseMin(point);
        upper_ = upper_.cwiseMax(point);
    }
    [[nodiscard]] Bounds grown_by(float reach) const {
        const Vector3 margin = Vector3::Constant(reach);
        return {to_vec3(lower_ - margin), to_vec3(upper_ + margin)};
    }

  private:
    static constexpr float infinity = std::numeric_limits<float>::infinity();
    Vector3 lower_ = Vector3::Constant(infinity), upper_ = -lower_;
};

/// Swept range of the cloth over h seconds at its present velocities, and its longest path.
ExpectedWay way_of(const Cloth& cloth, float h) {
    GrowingBox box;
    float squared = 0;
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        const Vector3 here = xyz(cloth.state.positions[i]), way = h * xyz(cloth.state.velocities[i]);
        box.add(here);
        box.add(here + way);
        squared = std::max(squared, way.squaredNorm());
    }
    return {.box = box.grown_by(cloth.as_body().radius), .length = std::sqrt(squared)};
}

/// Greatest distance by which the collider pushes particles in the box [m].
float push_of(const ColliderMotion& motion, const Pace& pace, float thickness, const Bounds& box) {
    const Reach reach{thickness + motion.end.thickness, 0};
    return with_shapes(motion, [&](const auto& start, const auto& end) {
        if (!may_meet(start, end, pace, reach, BlockPaths{box, 0})) return 0.0f;
        return std::max(0.0f, sweeping(start, end, pace, reach.thickness).way);
    });
}

/// A group that anything but free bodies pushes need not keep its momentum. Returns whether one is.
bool is_pushed_from_outside(const Worker& worker, std::span<Cloth* const> cloths) {
    constexpr auto is_of_no_body = [](const ColliderMotion& motion) { return motion.body < 0; };
    return std::ranges::any_of(cloths, [&](Cloth* cloth) {
        return cloth->worn.is_holding() || (cloth->collider_contacts > 0 &&
                                            std::ranges::any_of(colliders_of(worker, *cloth), is_of_no_body));
    });
}

/// Stores the tangle memory, unless nothing crosses or has crossed: calm cloth costs nothing.
void remember_tangles(FeatureContact& space, std::size_t body, ClothState& state) {
    if (state.may_cross == 0 && !space.may_cross()) return;
    std::ranges::copy(space.memory(body), state.tangles.data());
    state.may_cross = space.may_cross() ? 1 : 0;
}

/// Grows the box of each cloth by the longest path in its group. Returns whether any has grown.
bool pass_ways_on(Simulation& world) {
    const std::span<const std::uint32_t> first_of = world.group_finder.first_of();
    for (std::size_t i = 0; i < world.present.size(); ++i) {
        ExpectedWay& of_first = world.present[first_of[i]]->expected;
        if (first_of[i] != i)
            of_first.longest =
                std::max({of_first.longest, of_first.length, world.present[i]->expected.length});
    }
    bool any = false;
    for (std::size_t i = 0; i < world.present.size(); ++i) {
        ExpectedWay& own = world.present[i]->expected;
        const float more = world.present[first_of[i]]->expected.longest - own.grown_by;
        if (!(more > 0)) continue;
        own.box = grown(own.box, more);
        own.grown_by += more;
        any = true;
    }
    return any;
}

/// The cloth's own space: as long as each cloth stays in its own, groups cannot meet.
Bounds own_space_of(const Simulation& world, const Cloth& cloth) {
    OwnSpace space(cloth.expected.box, cloth.as_body().floor);
    for (const Cloth* other : world.present)
        if (other->group != cloth.group && other->has_features() && may_meet(cloth, *other))
            space.keep_from(other->expected.box);
    return space.bounds();
}

/// Shortens motions that end outside the predicted box, and would leave the cloth's own space.
void keep_in_own_space(const Simulation& world, Worker& worker, FeatureContact& space,
                       std::span<Cloth* const> cloths) {
    if (world.featured_cloths == 1) return;
    for (std::size_t k = 0; k < cloths.size(); ++k)
        if (space.leaves(worker.parallel, k, cloths[k]->expected.box))
            space.keep_within(worker.parallel, k, own_space_of(world, *cloths[k]));
}

/// Writes a body's settled motion to its cloth.
void hand_back(Simulation& world, Worker& worker, const FeatureContact& space, std::size_t body, Cloth& cloth,
               float h) {
    space.hand_back(worker.parallel, body, h, cloth.state.positions.span(), cloth.state.velocities.span());
    limit_speeds(worker.parallel, world.settings.max_speed, cloth.state.velocities.span());
}

// Zones pass momentum on to cloth that lies on a collider, so colliders come last (Huh, Metaxas, Badler 2001,
// section 2: cloth against rigid bodies on top of cloth against cloth).
void keep_out_of_colliders(Simulation& world, Worker& worker, Cloth& cloth, float h) {
    if (colliders_of(worker, cloth).empty() || !meets_in_equation(cloth.settings)) return;
    cloth.collider_contacts = std::max(cloth.collider_contacts, collide(world, worker, cloth, h, {}));
}

}  // namespace

/// Predicts the cloth's swept range in a substep of h seconds, enlarged by colliders' push in the whole step.
void expect(const Simulation& world, Cloth& cloth, float h) {
    if (!cloth.has_features()) return;
    cloth.expected = way_of(cloth, h);
    float push = 0;
    world.state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
        if (slot.target.is_trigger || (slot.target.layers & cloth.settings.collider_mask) == 0) return;
        ColliderMotion motion{slot.current, slot.target, world.settings.max_speed};
        motion.held = world.held_by(slot.target);
        push = std::max(push, push_of(motion, {h, world.settings.max_speed}, cloth.settings.thickness,
                                      cloth.expected.box));
    });
    cloth.expected.length += push;
    cloth.expected.box = grown(cloth.expected.box, push);
}

// Cloths whose swept ranges overlap, that seams join, or that may meet the same body, are solved together.
// They pass momentum on to one another, so that each may go as far as the fastest: boxes grow, and groups are
// found anew.
void meet(Simulation& world) {
    for (bool any = true; any;) {
        world.boxes.clear();
        for (const Cloth* cloth : world.present)
            world.boxes.push_back(cloth->has_features() ? cloth->expected.box : no_box);
        world.group_finder.find(world.boxes, [&](std::uint32_t i, std::uint32_t j) {
            return may_meet(*world.present[i], *world.present[j]);
        });
        if (world.body_stage) world.group_finder.join(world.body_stage->sharing.first_of());
        join_seams(world);
        any = pass_ways_on(world);
    }
    for (std::size_t i = 0; i < world.present.size(); ++i)
        world.present[i]->group = world.group_finder.first_of()[i];
    world.groups.plan(world.present, world.group_finder.first_of(), world.parallel.width());
}

void find_features(Simulation& world, Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths,
                   float h) {
    const auto timer = world.timed(Stage::self_search);
    for (std::size_t k = 0; k < cloths.size(); ++k) {
        const ClothState& now = cloths[k]->state;
        space.place(worker.parallel, k, now.positions.span(), {.velocities = now.velocities.span(), .h = h});
        if (now.may_cross != 0) space.recall(k, now.tangles.span());
    }
    if (!space.uses_zones()) space.detect(worker.parallel, cloths.front()->is_in_crowd);
}

/// Whether the common motion has moved any of the cloth out of its own space.
bool is_taken_out_of_own_space(const Simulation& world, Worker& worker, FeatureContact& space,
                               std::size_t body, const Cloth& cloth) {
    return world.featured_cloths > 1 && space.leaves(worker.parallel, body, cloth.expected.box) &&
           space.leaves(worker.parallel, body, own_space_of(world, cloth));
}

// The last stage that moves particles in a substep.
void settle_features(Simulation& world, Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths,
                     const Substep& substep) {
    const auto timer = world.timed(Stage::self_response);
    for (std::size_t k = 0; k < cloths.size(); ++k) {
        if (cloths[k]->impulse_ratio > 0)
            std::ranges::copy(std::as_const(cloths[k]->state.velocities).span(),
                              cloths[k]->scratch_velocities.data());
        if (substep.is_last()) cloths[k]->place_pins();
        space.arrive(worker.parallel, k, cloths[k]->state.positions.span());
        cloths[k]->feature_counts = {};
    }
    FeatureCounts& counts = cloths.front()->feature_counts;
    if (!space.uses_zones()) {
        space.project(worker.parallel);
        keep_in_own_space(world, worker, space, cloths);
    }
    const bool is_pushed = is_pushed_from_outside(worker, cloths);
    counts = space.cut(worker.parallel, is_pushed);
    if (space.uses_zones()) {
        keep_in_own_space(world, worker, space, cloths);
    } else {
        keep_common_motion_out(world, worker, space, cloths, substep.h);
        if (counts.truncated > 0) counts = space.go_on(worker.parallel, is_pushed);
    }
    if constexpr (looks_for_new_crossings) counts.crossed = space.crosses_anew(worker.parallel);
    for (std::size_t k = 0; k < cloths.size(); ++k) {
        hand_back(world, worker, space, k, *cloths[k], substep.h);
        if (space.uses_zones()) keep_out_of_colliders(world, worker, *cloths[k], substep.h);
        remember_tangles(space, k, cloths[k]->state);
    }
    if (world.reports_contacts() && !space.uses_zones()) log_pairs(worker, space, cloths);
}

}  // namespace weft
