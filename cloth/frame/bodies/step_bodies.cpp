// The part of the frame that bodies have: how they move, and what cloths give them.

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <limits>

#include "cloth/frame/bodies/free_cloth.h"
#include "cloth/frame/simulation.h"
#include "engine/bounds.h"

namespace weft {

namespace {

Vector6 to_vector6(const std::array<float, 6>& values) {
    Vector6 v;
    for (int k = 0; k < 6; ++k) v[k] = static_cast<double>(values[static_cast<std::size_t>(k)]);
    return v;
}
std::array<float, 6> to_floats(const Vector6& v) {
    std::array<float, 6> values{};
    for (int k = 0; k < 6; ++k) values[static_cast<std::size_t>(k)] = static_cast<float>(v[k]);
    return values;
}

/// Else bodies get what came of their going on as they did.
bool are_solved_with_bodies(std::span<Cloth* const> cloths) {
    return std::ranges::all_of(cloths, [](const Cloth* cloth) { return cloth->solver->joins(); });
}

/// BDF2 has more to give.
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

/// The box's least distance from a point would be this far, were both where they are.
Bounds box_of(const Collider& collider, const HeldShape* held) {
    const Sphere ball = ball_around(collider, held);
    const Vector3 centre = to_vector(ball.center), reach = Vector3::Constant(ball.radius);
    return {to_vec3(centre - reach), to_vec3(centre + reach)};
}

/// In single precision, as hosts get it.
bool is_finite(const Vector6& impulse) {
    return impulse.cast<float>().allFinite();
}

/// The end of a part: where the body is, and how it moves with what cloth gave it.
void arrive(MovingBody& body, const Vector6& given, bool is_solved_for) {
    const Vector6 after = body.limited(body.drift + body.root * (body.root.transpose() * given));
    if (!is_solved_for) {
        body.now = after;
        body.find_end();
    }
    body.start = body.end;
    body.velocity = after;
}

}  // namespace

void Simulation::begin_bodies(const Substep& substep) {
    if (!bodies_) return;
    BodyStage& stage = *bodies_;
    stage.were_taken = false;
    std::size_t k = 0;
    state.bodies.for_each([&](BodyId id, const BodySlot& slot) {
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
    limit_bodies();
    load_bodies();
    take_bodies({}, substep.h);
    for (Cloth* cloth : present_)
        for (Attachment& attached : cloth->attached)
            attached.body = static_cast<std::uint32_t>(number_of(attached.id));
    find_cloths_of_bodies(substep.h);
}

/// Finds the cloths that may meet bodies in the substep, and which of them share one that gives way.
void Simulation::find_cloths_of_bodies(float h) {
    BodyStage& stage = *bodies_;
    constexpr std::uint32_t none = ~0u;
    stage.first_cloths.assign(stage.moving.size(), none);
    stage.sharing.begin(present_.size());
    for (std::uint32_t i = 0; i < present_.size(); ++i) {
        Cloth& cloth = *present_[i];
        cloth.meets_bodies = false;
        for_each_body_near(cloth, h, [&](std::size_t k) {
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

/// How fast bodies may be: attached particles, too, keep to max_speed.
void Simulation::limit_bodies() {
    for (MovingBody& body : bodies_->moving) {
        body.fastest = static_cast<double>(settings.max_speed);
        body.reach = 0;
    }
    for (const Cloth* cloth : present_)
        for (const Attachment& attached : cloth->attached) {
            MovingBody& body = bodies_->moving[number_of(attached.id)];
            body.reach = std::max(body.reach, static_cast<double>(attached.own.norm()));
        }
}

/// Where the substep begins.
void Simulation::load_bodies() {
    std::size_t k = 0;
    state.bodies.for_each([&](BodyId, const BodySlot& slot) {
        BodyStage::Begin& begin = bodies_->begins[k];
        begin.pose = pose_of(slot.state);
        begin.velocity << to_vector(slot.state.velocity).cast<double>(),
            to_vector(slot.state.angular_velocity).cast<double>();
        begin.velocity = bodies_->moving[k++].limited(begin.velocity);
    });
}

/// Visits the numbers of the bodies that the cloth is attached to, or that can come near it in the substep,
/// each at least once. In that substep all others leave it alone.
template <class Visit>
void Simulation::for_each_body_near(const Cloth& cloth, float h, const Visit& visit) const {
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
    state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
        if (state.bodies.find(slot.body) == nullptr) return;
        if (slot.own.is_trigger || (slot.own.layers & cloth.settings.collider_mask) == 0) return;
        const std::size_t k = number_of(slot.body);
        const MovingBody& body = bodies_->moving[k];
        const float way = 2 * h * body.now.head<3>().cast<float>().norm();
        if (overlap(box, grown(box_of(carried(slot.own, body.start), held_by(slot.own)), way)) ||
            overlap(box, grown(box_of(carried(slot.own, body.end), held_by(slot.own)), way)))
            visit(k);
    });
}

/// Before a step: whether it is attached to one, or one may come near it.
bool Simulation::is_near_bodies(const Cloth& cloth, float dt) const {
    if (!cloth.attached.empty()) return true;
    constexpr float about = 0.05f;
    bool any = false;
    state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
        const BodySlot* const body = state.bodies.find(slot.body);
        if (any || body == nullptr) return;
        if (slot.own.is_trigger || (slot.own.layers & cloth.settings.collider_mask) == 0) return;
        const Sphere own = ball_around(slot.own, held_by(slot.own));
        const float arm = to_vector(own.center).norm() + own.radius;
        const float fall = dt * body->settings.gravity_scale * to_vector(settings.gravity).norm();
        const float speed = to_vector(body->state.velocity).norm() + std::abs(fall) +
                            arm * to_vector(body->state.angular_velocity).norm();
        any = overlap(grown({cloth.extent.lower, cloth.extent.upper},
                            cloth.settings.thickness + slot.own.thickness + about + dt * speed),
                      box_of(slot.current, held_by(slot.current)));
    });
    return any;
}

void Simulation::add_carried_motions(std::vector<ColliderMotion>& motions, std::uint32_t mask,
                                     const Substep& substep) const {
    bodies_->carried.clear();
    const auto add = [&](std::size_t k) {
        const MovingBody& body = bodies_->moving[k];
        state.colliders.for_each([&](ColliderId, const ColliderSlot& slot) {
            if (slot.own.is_trigger || (slot.own.layers & mask) == 0) return;
            if (state.bodies.find(slot.body) == nullptr || number_of(slot.body) != k) return;
            bodies_->carried.push_back({.motion = static_cast<std::uint32_t>(motions.size()),
                                        .body = static_cast<std::uint32_t>(k),
                                        .own = &slot.own});
            ColliderMotion& motion =
                motions.emplace_back(ColliderMotion{slot.current, slot.current, settings.max_speed});
            motion.held = held_by(slot.own);
            if (motion.held != nullptr && motion.held->deforms_in(state.steps))
                motion.rate = 1 / (substep.h * static_cast<float>(substep.count));
            body.move(slot.own, motion);
            motion.body = static_cast<std::int32_t>(k);
        });
    };
    for (const bool gives_way : {false, true})  // see Contacts::carry()
        for (std::size_t k = 0; k < bodies_->moving.size(); ++k)
            if (bodies_->moving[k].gives_way() == gives_way) add(k);
    bodies_->coupling.begin(bodies_->moving, bodies_->carried, motions);
}

/// The equation of a cloth that may meet bodies has them.
void Simulation::carry_bodies(Cloth& cloth, StepEquation& equation) {
    if (!cloth.contacts) return;
    cloth.contacts->carry(bodies_->moving, cloth.attached, cloth.model.rest_area.span(), cloth.body_buffers);
    equation.velocity_changes = equation.gamma != equation.h
                                    ? std::as_const(cloth.state.record.velocity_changes).span()
                                    : std::span<const Vec4>();
    if (!cloth.solver->joins()) return;
    bodies_->coupling.join(equation);
    equation.bodies = &bodies_->coupling;
}

/// A group takes bodies along over a substep of h seconds.
void Simulation::take_bodies(std::span<Cloth* const> cloths, float h) {
    BodyStage& stage = *bodies_;
    stage.h = h;
    for (Cloth* cloth : cloths) std::ranges::fill(cloth->collected, CollectedShare{});
    stage.were_taken |= !cloths.empty();
    start_part_of_bodies(cloths, h, h);
}

/// A set of the group takes them along over a part of it.
void Simulation::start_part_of_bodies(std::span<Cloth* const> cloths, float h, float gamma) {
    BodyStage& stage = *bodies_;
    for (std::size_t k = 0; k < stage.moving.size(); ++k) {
        stage.moving[k].start = stage.begins[k].pose;
        stage.moving[k].velocity = stage.begins[k].velocity;
    }
    const double part = static_cast<double>(h / stage.h), step = static_cast<double>(h);
    for (std::size_t k = 0; k < stage.moving.size(); ++k) {
        MovingBody& body = stage.moving[k];
        const BodySettings& of = stage.settings[k];
        body.h = h;
        body.gamma = gamma;
        body.set_root(body.start.rotation);
        body.drift = body.velocity;
        if (body.inverse_mass > 0)
            body.drift.head<3>() +=
                step * static_cast<double>(of.gravity_scale) * to_vector(settings.gravity).cast<double>();
        body.drift.head<3>() /= 1 + step * static_cast<double>(of.damping);
        body.drift.tail<3>() /= 1 + step * static_cast<double>(of.angular_damping);
        Vector6 others = Vector6::Zero(), expected = Vector6::Zero(), echo = Vector6::Zero();
        for (Cloth* cloth : present_) {
            const bool is_other = std::ranges::find(cloths, cloth) == cloths.end();
            const BodyShare& share = cloth->state.shares[k];
            CollectedShare& collected = cloth->collected[k];
            const Vector6 as_before = part * to_vector6(share.last);
            if (is_other) {
                others += collected.is_known ? collected.in_part : as_before;
                continue;
            }
            if (cloth->solver->joins()) expected += as_before;
            collected.in_part.setZero();
            collected.by_stops.setZero();
            if (const Bdf bdf = cloth->bdf_of(h, gamma); bdf.is_second_order())
                collected.in_part = to_vector6(share.echo) / static_cast<double>(bdf.divisor);
            echo += collected.in_part;
        }
        const auto moved_by = [&](const Vector6& impulse) -> Vector6 {
            return body.root * (body.root.transpose() * impulse);
        };
        body.drift += moved_by(others);
        if (body.is_uneven()) {
            body.momentum = body.inverse_inertia_at(body.start.rotation).inverse() * body.drift.tail<3>();
            body.turn_freely();
        }
        body.expected = are_solved_with_bodies(cloths) ? Vector6(expected - echo) : Vector6(Vector6::Zero());
        const auto expect = [&] {
            body.free = body.drift + moved_by(echo);
            body.expect();
        };
        expect();
        if (!body.is_uneven()) continue;
        body.turn_inertia();
        expect();
    }
}

/// What the equation that was solved gave bodies.
void Simulation::collect_from_equation(Cloth& cloth, const StepEquation& equation) {
    if (!cloth.meets_bodies || !cloth.contacts) return;
    const std::span<const Vec4> velocities = std::as_const(cloth.next_velocities).span();
    if (!cloth.solver->joins()) cloth.contacts->find_pushes(equation, velocities);
    for (const BodyPush& push : std::as_const(*cloth.contacts).pushes()) {
        const std::uint32_t i = push.particle;
        const Vector3 v = xyz(velocities[i]);
        const Vector3 there = xyz(equation.base_positions[i]) + equation.gamma * v;
        const Vector3 arm = there - bodies_->moving[push.body].end.position;
        const Vector3 given = cloth.contacts->of_colliders(i, v) + forgotten(equation, i);
        cloth.collected[push.body].in_part -= wrench(arm.cast<double>(), given.cast<double>());
    }
    for (const BodyStop& stop : cloth.contacts->stops()) {
        const MovingBody& body = bodies_->moving[stop.body];
        const Vector3 change = body.velocity_at(body.end.position + stop.arm) - stop.velocity;
        const Vector3 given = stop.impulse + stop.response * change;
        cloth.collected[stop.body].by_stops -= wrench(stop.arm.cast<double>(), given.cast<double>());
    }
    for (CollectedShare& share : cloth.collected) share.in_part += share.by_stops;
    // A body that other cloths hold, too, is not this one's to move.
    if (bodies_->coupling.cloths() < 2) keep_momentum_with_bodies(cloth, equation, bodies_->moving);
    bodies_->coupling.move_colliders();
    for (std::size_t k = 0; k < cloth.collected.size(); ++k) {
        const CollectedShare& share = cloth.collected[k];
        cloth.state.shares[k].echo =
            cloth.history ? to_floats(share.in_part - share.by_stops) : std::array<float, 6>{};
    }
}

/// A particle's velocity was changed since a body is where it is.
void Simulation::collect_change(Cloth& cloth, std::uint32_t body, std::uint32_t particle,
                                const Vector3& change) {
    const Vec4& position = cloth.state.positions[particle];
    const Vector3 arm = xyz(position) - bodies_->moving[body].end.position;
    cloth.collected[body].in_part -= wrench(arm.cast<double>(), (change / position.w).cast<double>());
}

// Bodies first: what stands still has the last word.
std::uint32_t Simulation::collide_with_bodies(Worker& worker, Cloth& cloth, float h,
                                              std::span<const Vec4> starts) {
    const std::span<const ColliderMotion> motions = colliders_of(worker, cloth);
    std::uint32_t touching = 0;
    for (std::size_t end = motions.size(), begin = end; end > 0; end = begin) {
        const std::int32_t body = motions[end - 1].body;
        while (begin > 0 && motions[begin - 1].body == body) --begin;
        std::ranges::copy(std::as_const(cloth.state.velocities).span(), cloth.next_velocities.data());
        const std::uint32_t met =
            weft::collide(worker.parallel, motions.subspan(begin, end - begin), side_of_cloth(cloth, h), h,
                          {.positions = cloth.state.positions.span(),
                           .velocities = cloth.state.velocities.span(),
                           .starts = starts,
                           .held = std::as_const(cloth.state.held.normals).span(),
                           .factors = cloth.worn.factors(),
                           .whole = cloth.whole ? &*cloth.whole : nullptr},
                          cloth.partial_counts.span());
        touching += met;
        if (met == 0) continue;
        if (reports_contacts())
            add_impulses_of_change(worker, cloth, std::as_const(cloth.next_velocities).span());
        if (body < 0) continue;
        for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
            const Vector3 change = xyz(cloth.state.velocities[i]) - xyz(cloth.next_velocities[i]);
            if (!change.isZero(0)) collect_change(cloth, static_cast<std::uint32_t>(body), i, change);
        }
    }
    return touching;
}

/// Puts attached particles where their bodies are. A body and what is attached to it, of all these cloths,
/// get the velocity at which their momentum is what it was: a body that gave way alone would fly where they
/// are heavier than it is.
void Simulation::place_attached(std::span<Cloth* const> cloths) {
    const auto has_any = [](const Cloth* cloth) { return cloth->meets_bodies && !cloth->attached.empty(); };
    if (std::ranges::none_of(cloths, has_any)) return;
    for (std::uint32_t body = 0; body < bodies_->moving.size(); ++body) join_attached(cloths, body);
}

void Simulation::join_attached(std::span<Cloth* const> cloths, std::uint32_t number) {
    MovingBody& body = bodies_->moving[number];
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
    const Vector6 along_root = joint.ldlt().solve(Vector6(body.root.transpose() * lacking));
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

void Simulation::finish_part_of_bodies(std::span<Cloth* const> cloths) {
    for (std::size_t k = 0; k < bodies_->moving.size(); ++k) {
        Vector6 given = Vector6::Zero();
        for (Cloth* cloth : cloths) {
            CollectedShare& share = cloth->collected[k];
            if (!is_finite(share.in_part)) share.in_part.setZero();  // of a cloth that is put back
            share.sum += share.in_part;
            share.is_known = true;
            given += share.in_part;
        }
        bodies_->given[k] += given;
        arrive(bodies_->moving[k], given, are_solved_with_bodies(cloths));
    }
}

/// The group's next part goes on from where this one has brought bodies.
void Simulation::end_part_of_bodies(std::span<Cloth* const> cloths) {
    BodyStage& stage = *bodies_;
    for (std::size_t k = 0; k < stage.moving.size(); ++k)
        stage.begins[k] = {stage.moving[k].start, stage.moving[k].velocity};
    for (Cloth* cloth : cloths)
        for (CollectedShare& share : cloth->collected) share.is_known = false;
}

/// What cloths gave while they took bodies along is expected of them again.
void Simulation::leave_bodies(std::span<Cloth* const> cloths) {
    for (Cloth* cloth : cloths)
        for (std::size_t k = 0; k < cloth->collected.size(); ++k)
            cloth->state.shares[k].last = to_floats(cloth->collected[k].sum);
    load_bodies();
}

void Simulation::end_bodies(const Substep& substep) {
    if (!bodies_) return;
    BodyStage& stage = *bodies_;
    if (!stage.were_taken) {
        take_bodies({}, substep.h);
        finish_part_of_bodies({});
    }
    std::size_t k = 0;
    state.bodies.for_each([&](BodyId, BodySlot& slot) {
        const MovingBody& body = stage.moving[k];
        Vector6 velocity = body.limited(body.velocity);
        limit_length(velocity.tail<3>(), 1e4);
        if (substep.is_last()) {
            const Vector6 given = is_finite(stage.given[k]) ? stage.given[k] : Vector6(Vector6::Zero());
            stage.impulses[k].linear = to_vec3(given.head<3>().cast<float>());
            stage.impulses[k].angular = to_vec3(given.tail<3>().cast<float>());
        }
        ++k;
        // Where it cannot be it does not go.
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
    place_carried_colliders();
}

}  // namespace weft
