// How bodies move in a step.

#include <algorithm>
#include <cmath>

#include "cloth/stages/step_bodies.h"
#include "cloth/stages/worn_step.h"
#include "engine/bounds.h"

namespace weft {

namespace {

/// Whether bodies are unknowns of the equation. Otherwise they coast through it and receive the reaction
/// impulse afterwards.
bool are_solved_with_bodies(std::span<Cloth* const> cloths) {
    return std::ranges::all_of(cloths, [](const Cloth* cloth) { return cloth->solver->joins(); });
}

/// Whether BDF2 still extrapolates an impulse of earlier steps.
bool is_still_heard(const BodyShare& share) {
    return std::ranges::any_of(share.echo, [](float part) { return std::abs(part) > 1e-10f; });
}

double inverse(float value) {
    return value > 0 ? 1 / static_cast<double>(value) : 0;
}

void limit_length(Eigen::Ref<Eigen::Vector3d> v, double most) {
    const double length = v.norm();
    if (length > most) v *= most / length;
}

/// Whether the impulse is finite in single precision, as hosts get it.
bool is_finite(const Vector6& impulse) {
    return impulse.cast<float>().allFinite();
}

/// Ends a part: sets the body's pose and velocity from the impulse that cloth gave it.
void arrive(MovingBody& body, const Vector6& given, bool is_solved_for) {
    const Vector6 after = body.limited(body.drift + body.root * (body.root.transpose() * given));
    if (!is_solved_for) {
        body.now = after;
        body.find_end();
    }
    body.start = body.end;
    body.velocity = after;
}

/// Visits the numbers of the bodies that the cloth is attached to, or that can come near it in the substep,
/// each at least once. No other body touches the cloth in that substep.
template <class Visit>
void for_each_body_near(const Simulation& world, const Cloth& cloth, float h, const Visit& visit) {
    for (const Attachment& attached : cloth.attached) visit(attached.body);
    for (std::size_t k = 0; k < cloth.state.shares.size(); ++k)
        if (is_still_heard(cloth.state.shares[k])) visit(k);
    if (!meets_in_equation(cloth.settings)) return;
    float fastest = std::sqrt(cloth.extent.peak_speed_squared);
    for (const Pin& pin : cloth.state.pins)
        fastest = std::max(fastest, xyz(cloth.state.velocities[pin.particle]).norm());
    constexpr float about = 0.05f;
    const Bounds box =
        grown({cloth.extent.lower, cloth.extent.upper}, cloth.settings.thickness + 2 * h * fastest + about);
    world.state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
        if (world.state.bodies.find(slot.body) == nullptr) return;
        if (slot.own.is_trigger || (slot.own.layers & cloth.settings.collider_mask) == 0) return;
        const std::size_t k = world.number_of(slot.body);
        const MovingBody& body = world.body_stage->moving[k];
        const float way = 2 * h * body.now.head<3>().cast<float>().norm();
        if (overlap(box, grown(box_of(carried(slot.own, body.start), world.held_by(slot.own)), way)) ||
            overlap(box, grown(box_of(carried(slot.own, body.end), world.held_by(slot.own)), way)))
            visit(k);
    });
}

/// Finds the cloths that may meet bodies in the substep, and groups those that may meet one movable body.
void find_cloths_of_bodies(Simulation& world, float h) {
    BodyStage& stage = *world.body_stage;
    constexpr std::uint32_t none = ~0u;
    stage.first_cloths.assign(stage.moving.size(), none);
    stage.sharing.begin(world.present.size());
    for (std::uint32_t i = 0; i < world.present.size(); ++i) {
        Cloth& cloth = *world.present[i];
        cloth.meets_bodies = false;
        for_each_body_near(world, cloth, h, [&](std::size_t k) {
            cloth.meets_bodies = true;
            if (!stage.moving[k].gives_way()) return;
            std::uint32_t& first = stage.first_cloths[k];
            if (first == none) first = i;
            stage.sharing.join(first, i);
        });
        if (!cloth.meets_bodies) std::ranges::fill(cloth.state.shares, BodyShare{});
    }
    stage.sharing.end();
}

/// Limits the speed of bodies, so that attached particles keep to max_speed, too.
void limit_bodies(Simulation& world) {
    for (MovingBody& body : world.body_stage->moving) {
        body.fastest = static_cast<double>(world.settings.max_speed);
        body.reach = 0;
    }
    for (const Cloth* cloth : world.present)
        for (const Attachment& attached : cloth->attached) {
            MovingBody& body = world.body_stage->moving[world.number_of(attached.id)];
            body.reach = std::max(body.reach, static_cast<double>(attached.own.norm()));
        }
}

/// Loads the poses and velocities that the substep begins with.
void load_bodies(Simulation& world) {
    std::size_t k = 0;
    world.state.bodies.for_each([&](BodyId, const BodySlot& slot) {
        BodyStage::Begin& begin = world.body_stage->begins[k];
        begin.pose = pose_of(slot.state);
        begin.velocity << to_vector(slot.state.velocity).cast<double>(),
            to_vector(slot.state.angular_velocity).cast<double>();
        begin.velocity = world.body_stage->moving[k++].limited(begin.velocity);
    });
}

}  // namespace

Bounds box_of(const Collider& collider, const HeldShape* held) {
    const Sphere ball = ball_around(collider, held);
    const Vector3 centre = to_vector(ball.center), reach = Vector3::Constant(ball.radius);
    return {to_vec3(centre - reach), to_vec3(centre + reach)};
}

void begin_bodies(Simulation& world, const Substep& substep) {
    if (!world.body_stage) return;
    BodyStage& stage = *world.body_stage;
    stage.were_taken = false;
    std::size_t k = 0;
    world.state.bodies.for_each([&](BodyId id, const BodySlot& slot) {
        MovingBody& body = stage.moving[k];
        body.inverse_mass = inverse(slot.settings.mass);
        const Vector3 inertia = to_vector(slot.settings.inertia);
        for (int axis = 0; axis < 3; ++axis) body.inverse_inertia[axis] = inverse(inertia[axis]);
        stage.settings[k] = slot.settings;
        if (substep.is_first()) {
            stage.given[k].setZero();
            stage.impulses[k].body = id;
        }
        ++k;
    });
    limit_bodies(world);
    load_bodies(world);
    fill_motions(world, stage.others, ~0u, substep, nullptr);
    take_bodies(world, {}, substep);
    for (Cloth* cloth : world.present)
        for (Attachment& attached : cloth->attached)
            attached.body = static_cast<std::uint32_t>(world.number_of(attached.id));
    find_cloths_of_bodies(world, substep.h);
}

bool is_near_bodies(const Simulation& world, const Cloth& cloth, float dt) {
    if (!cloth.attached.empty()) return true;
    constexpr float about = 0.05f;
    bool any = false;
    world.state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
        const BodySlot* const body = world.state.bodies.find(slot.body);
        if (any || body == nullptr) return;
        if (slot.own.is_trigger || (slot.own.layers & cloth.settings.collider_mask) == 0) return;
        const Sphere own = ball_around(slot.own, world.held_by(slot.own));
        const float arm = to_vector(own.center).norm() + own.radius;
        const float fall = dt * body->settings.gravity_scale * to_vector(world.settings.gravity).norm();
        const float speed = to_vector(body->state.velocity).norm() + std::abs(fall) +
                            arm * to_vector(body->state.angular_velocity).norm();
        any = overlap(grown({cloth.extent.lower, cloth.extent.upper},
                            cloth.settings.thickness + slot.own.thickness + about + dt * speed),
                      box_of(slot.current, world.held_by(slot.current)));
    });
    return any;
}

void add_carried_motions(const Simulation& world, std::vector<ColliderMotion>& motions, std::uint32_t mask,
                         const Substep& substep) {
    world.body_stage->carried.clear();
    const auto add = [&](std::size_t k) {
        const MovingBody& body = world.body_stage->moving[k];
        world.state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
            if (slot.own.is_trigger || (slot.own.layers & mask) == 0) return;
            if (world.state.bodies.find(slot.body) == nullptr || world.number_of(slot.body) != k) return;
            world.body_stage->carried.push_back({.motion = static_cast<std::uint32_t>(motions.size()),
                                                 .body = static_cast<std::uint32_t>(k),
                                                 .own = &slot.own});
            ColliderMotion& motion =
                motions.emplace_back(ColliderMotion{slot.current, slot.current, world.settings.max_speed});
            motion.held = world.held_by(slot.own);
            if (motion.held != nullptr && motion.held->deforms_in(world.state.steps))
                motion.rate = 1 / (substep.h * static_cast<float>(substep.count));
            body.move(slot.own, motion);
            motion.body = static_cast<std::int32_t>(k);
        });
    };
    for (const bool gives_way : {false, true})  // see Contacts::carry()
        for (std::size_t k = 0; k < world.body_stage->moving.size(); ++k)
            if (world.body_stage->moving[k].gives_way() == gives_way) add(k);
    world.body_stage->coupling.begin(world.body_stage->moving, world.body_stage->carried, motions);
}

void take_bodies(Simulation& world, std::span<Cloth* const> cloths, const Substep& substep) {
    BodyStage& stage = *world.body_stage;
    stage.substep = substep;
    for (Cloth* cloth : cloths) std::ranges::fill(cloth->collected, CollectedShare{});
    stage.were_taken |= !cloths.empty();
    start_part_of_bodies(world, cloths, substep, substep.h);
}

void start_part_of_bodies(Simulation& world, std::span<Cloth* const> cloths, const Substep& part,
                          float gamma) {
    BodyStage& stage = *world.body_stage;
    const float h = part.h;
    for (std::size_t k = 0; k < stage.moving.size(); ++k) {
        stage.moving[k].start = stage.begins[k].pose;
        stage.moving[k].velocity = stage.begins[k].velocity;
    }
    const double share = static_cast<double>(h / stage.substep.h), step = static_cast<double>(h);
    for (std::size_t k = 0; k < stage.moving.size(); ++k) {
        MovingBody& body = stage.moving[k];
        const BodySettings& of = stage.settings[k];
        body.h = h;
        body.gamma = gamma;
        body.set_root(body.start.rotation);
        body.drift = body.velocity;
        if (body.inverse_mass > 0)
            body.drift.head<3>() += step * static_cast<double>(of.gravity_scale) *
                                    to_vector(world.settings.gravity).cast<double>();
        body.drift.head<3>() /= 1 + step * static_cast<double>(of.damping);
        body.drift.tail<3>() /= 1 + step * static_cast<double>(of.angular_damping);
        Vector6 others = Vector6::Zero(), expected = Vector6::Zero(), echo = Vector6::Zero();
        for (Cloth* cloth : world.present) {
            const bool is_other = std::ranges::find(cloths, cloth) == cloths.end();
            const BodyShare& given = cloth->state.shares[k];
            CollectedShare& collected = cloth->collected[k];
            const Vector6 as_before = share * to_vector6(given.last);
            if (is_other) {
                others += collected.is_known ? collected.in_part : as_before;
                continue;
            }
            if (cloth->solver->joins()) expected += as_before;
            collected.in_part.setZero();
            collected.by_stops.setZero();
            if (const Bdf bdf = cloth->bdf_of(h, gamma); bdf.is_second_order())
                collected.in_part = to_vector6(given.echo) / static_cast<double>(bdf.divisor);
            echo += collected.in_part;
        }
        const auto moved_by = [&](const Vector6& impulse) -> Vector6 {
            return body.root * (body.root.transpose() * impulse);
        };
        body.drift += moved_by(others);
        body.turn_freely();
        body.expected = are_solved_with_bodies(cloths) ? Vector6(expected - echo) : Vector6(Vector6::Zero());
        const auto expect = [&] {
            body.free = body.drift + moved_by(echo);
            body.expect();
        };
        expect();
        if (body.is_uneven()) {
            body.turn_inertia();
            expect();
        }
        stop_at_colliders(world, k, part);
    }
}

void finish_part_of_bodies(Simulation& world, std::span<Cloth* const> cloths) {
    for (std::size_t k = 0; k < world.body_stage->moving.size(); ++k) {
        Vector6 given = Vector6::Zero();
        for (Cloth* cloth : cloths) {
            CollectedShare& share = cloth->collected[k];
            if (!is_finite(share.in_part)) share.in_part.setZero();  // of a cloth that is put back
            share.sum += share.in_part;
            share.is_known = true;
            given += share.in_part;
        }
        world.body_stage->given[k] += given;
        arrive(world.body_stage->moving[k], given, are_solved_with_bodies(cloths));
    }
}

/// The group's next part begins at the poses and velocities that this one ended with.
void end_part_of_bodies(Simulation& world, std::span<Cloth* const> cloths) {
    BodyStage& stage = *world.body_stage;
    for (std::size_t k = 0; k < stage.moving.size(); ++k)
        stage.begins[k] = {stage.moving[k].start, stage.moving[k].velocity};
    for (Cloth* cloth : cloths)
        for (CollectedShare& share : cloth->collected) share.is_known = false;
}

/// Keeps the impulses that cloths gave as those that are expected of them in the next substep.
void leave_bodies(Simulation& world, std::span<Cloth* const> cloths) {
    for (Cloth* cloth : cloths)
        for (std::size_t k = 0; k < cloth->collected.size(); ++k)
            cloth->state.shares[k].last = to_floats(cloth->collected[k].sum);
    load_bodies(world);
}

void end_bodies(Simulation& world, const Substep& substep) {
    if (!world.body_stage) return;
    BodyStage& stage = *world.body_stage;
    if (!stage.were_taken) {
        take_bodies(world, {}, substep);
        finish_part_of_bodies(world, {});
    }
    std::size_t k = 0;
    world.state.bodies.for_each([&](BodyId, BodySlot& slot) {
        const MovingBody& body = stage.moving[k];
        Vector6 velocity = body.limited(body.velocity);
        limit_length(velocity.tail<3>(), 1e4);
        if (substep.is_last()) {
            const Vector6 given = is_finite(stage.given[k]) ? stage.given[k] : Vector6(Vector6::Zero());
            stage.impulses[k].linear = to_vec3(given.head<3>().cast<float>());
            stage.impulses[k].angular = to_vec3(given.tail<3>().cast<float>());
        }
        ++k;
        // A body that would leave the World's range stops where it was.
        const float farthest_out = body.start.position.cwiseAbs().maxCoeff();
        if (!velocity.allFinite() || !(farthest_out <= runaway_distance) ||
            !body.start.rotation.coeffs().allFinite()) {
            slot.state.velocity = slot.state.angular_velocity = {};
            return;
        }
        const Eigen::Quaternionf& r = body.start.rotation;
        slot.state = {.position = to_vec3(body.start.position),
                      .rotation = {r.x(), r.y(), r.z(), r.w()},
                      .velocity = to_vec3(velocity.head<3>().cast<float>()),
                      .angular_velocity = to_vec3(velocity.tail<3>().cast<float>())};
    });
    world.place_carried_colliders();
}

}  // namespace weft
