// Impulses between cloths and bodies in a part of a substep.

#include <algorithm>

#include "cloth/simulation/free_cloth.h"
#include "cloth/stages/collide_step.h"
#include "cloth/stages/report_contacts.h"
#include "cloth/stages/step_bodies.h"
#include "cloth/stages/worn_step.h"
#include "collision/thin/collide.h"
#include "engine/small_matrices.h"

namespace weft {

namespace {

/// Gives a body the reaction to a velocity change that it caused in a particle.
void collect_change(Simulation& world, Cloth& cloth, std::uint32_t body, std::uint32_t particle,
                    const Vector3& change) {
    const Vec4& position = cloth.state.positions[particle];
    const Vector3 arm = xyz(position) - world.body_stage->moving[body].end.position;
    cloth.collected[body].in_part -= wrench(arm.cast<double>(), (change / position.w).cast<double>());
}

void join_attached(Simulation& world, std::span<Cloth* const> cloths, std::uint32_t number) {
    MovingBody& body = world.body_stage->moving[number];
    const auto for_each_free = [&](Cloth& cloth, const auto& visit) {
        for (const Attachment& attached : cloth.attached) {
            const Vec4& position = cloth.state.positions[attached.particle];
            if (attached.body == number && position.w > 0)
                visit(attached.particle, Vector3(body.end * attached.own), 1 / position.w);
        }
    };
    Matrix6 inertia = Matrix6::Zero();
    Vector6 lacking = Vector6::Zero();
    const auto weigh = [&](Cloth& cloth) {
        for_each_free(cloth, [&](std::uint32_t i, const Vector3& place, float mass) {
            const Eigen::Vector3d arm = (place - body.end.position).cast<double>();
            inertia += at_arm(arm, static_cast<double>(mass) * Eigen::Matrix3d::Identity());
            const Vector3 lacks = mass * (xyz(cloth.state.velocities[i]) - body.velocity_at(place));
            lacking += wrench(arm, lacks.cast<double>());
        });
    };
    for (Cloth* cloth : cloths) weigh(*cloth);
    const Matrix6 joint = Matrix6::Identity() + body.root.transpose() * inertia * body.root;
    const Vector6 along_root = solve_by_ldlt(joint, body.root.transpose() * lacking);
    const Vector6 change = body.root * along_root;
    for (Cloth* cloth : cloths) {
        inertia.setZero();
        lacking.setZero();
        weigh(*cloth);
        cloth->collected[number].in_part += lacking - inertia * change;
    }
    body.now += change;
    for (Cloth* cloth : cloths)
        for_each_free(*cloth, [&](std::uint32_t i, const Vector3& place, float /*mass*/) {
            set_xyz(cloth->state.positions[i], place);
            set_xyz(cloth->state.velocities[i], body.velocity_at(place));
        });
}

}  // namespace

/// Puts bodies into the equation of a cloth that may meet them.
void carry_bodies(Simulation& world, Cloth& cloth, StepEquation& equation) {
    if (!cloth.contacts) return;
    cloth.contacts->carry(world.body_stage->moving, cloth.attached, cloth.model.rest_area.span(),
                          cloth.body_buffers);
    equation.velocity_changes = equation.gamma != equation.h
                                    ? std::as_const(cloth.state.record.velocity_changes).span()
                                    : std::span<const Vec4>();
    if (!cloth.solver->joins()) return;
    world.body_stage->coupling.join(equation);
    equation.bodies = &world.body_stage->coupling;
}

/// Collects the impulses that the solved equation gave bodies.
void collect_from_equation(Simulation& world, Cloth& cloth, const StepEquation& equation) {
    if (!cloth.meets_bodies || !cloth.contacts) return;
    const std::span<const Vec4> velocities = std::as_const(cloth.scratch_velocities).span();
    if (!cloth.solver->joins()) cloth.contacts->find_pushes(equation, velocities);
    for (const BodyPush& push : std::as_const(*cloth.contacts).pushes()) {
        const std::uint32_t i = push.particle;
        const Vector3 v = xyz(velocities[i]);
        const Vector3 there = xyz(equation.base_positions[i]) + equation.gamma * v;
        const Vector3 arm = cloth.contacts->is_attached(i)
                                ? push.arm
                                : there - world.body_stage->moving[push.body].end.position;
        const Vector3 given = cloth.contacts->of_colliders(i, v) + forgotten(equation, i);
        cloth.collected[push.body].in_part -= wrench(arm.cast<double>(), given.cast<double>());
    }
    for (const BodyStop& stop : cloth.contacts->stops()) {
        const MovingBody& body = world.body_stage->moving[stop.body];
        const Vector3 change = body.velocity_at(body.end.position + stop.arm) - stop.velocity;
        const Vector3 given = stop.impulse + stop.response * change;
        cloth.collected[stop.body].by_stops -= wrench(stop.arm.cast<double>(), given.cast<double>());
    }
    for (CollectedShare& share : cloth.collected) share.in_part += share.by_stops;
}

/// Called after collect_from_equation() of all cloths of the equation.
void keep_momentum_of_bodies(Simulation& world, std::span<Cloth* const> cloths,
                             std::span<const StepEquation> equations) {
    keep_momentum_with_bodies(cloths, equations, world.body_stage->moving);
    world.body_stage->coupling.move_colliders();
    for (Cloth* cloth : cloths) {
        if (!cloth->meets_bodies || !cloth->contacts) continue;
        for (std::size_t k = 0; k < cloth->collected.size(); ++k) {
            const CollectedShare& share = cloth->collected[k];
            cloth->state.shares[k].echo =
                cloth->history ? to_floats(share.in_part - share.by_stops) : std::array<float, 6>{};
        }
    }
}

// Bodies come first, so that colliders that do not give way override them.
std::uint32_t collide_with_bodies(Simulation& world, Worker& worker, Cloth& cloth, float h,
                                  std::span<const Vec4> starts) {
    const std::span<const ColliderMotion> motions = colliders_of(worker, cloth);
    std::uint32_t touching = 0;
    for (std::size_t end = motions.size(), begin = end; end > 0; end = begin) {
        const std::int32_t body = motions[end - 1].body;
        while (begin > 0 && motions[begin - 1].body == body) --begin;
        std::ranges::copy(std::as_const(cloth.state.velocities).span(), cloth.scratch_velocities.data());
        const std::uint32_t met =
            weft::collide(worker.parallel, motions.subspan(begin, end - begin), side_of(world, cloth, h), h,
                          {.positions = cloth.state.positions.span(),
                           .velocities = cloth.state.velocities.span(),
                           .starts = starts,
                           .held = std::as_const(cloth.state.held.normals).span(),
                           .whole = cloth.whole ? &*cloth.whole : nullptr},
                          cloth.partial_counts.span());
        touching += met;
        if (met == 0) continue;
        if (world.reports_contacts())
            add_impulses_of_change(worker, cloth, std::as_const(cloth.scratch_velocities).span());
        if (body < 0) continue;
        for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
            const Vector3 change = xyz(cloth.state.velocities[i]) - xyz(cloth.scratch_velocities[i]);
            if (!change.isZero(0)) collect_change(world, cloth, static_cast<std::uint32_t>(body), i, change);
        }
    }
    return touching;
}

/// Moves attached particles to their places on bodies. A body and the particles attached to it, of all these
/// cloths, get the velocity that keeps their momentum: if the body alone gave way, heavier particles would
/// throw it.
void place_attached(Simulation& world, std::span<Cloth* const> cloths) {
    const auto has_any = [](const Cloth* cloth) { return cloth->meets_bodies && !cloth->attached.empty(); };
    if (std::ranges::none_of(cloths, has_any)) return;
    for (std::uint32_t body = 0; body < world.body_stage->moving.size(); ++body)
        join_attached(world, cloths, body);
}

}  // namespace weft
