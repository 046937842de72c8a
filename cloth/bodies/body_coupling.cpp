#include "cloth/bodies/body_coupling.h"

#include "cloth/equation/contacts.h"
#include "engine/small_matrices.h"

namespace weft {

namespace {

/// Velocity of the body's point at `arm`.
Eigen::Vector3d velocity_at(const Vector6& velocity, const Vector3& arm) {
    return velocity.head<3>() + Eigen::Vector3d(velocity.tail<3>()).cross(arm.cast<double>());
}

}  // namespace

Vector3 forgotten(const StepEquation& equation, std::uint32_t i) {
    if (equation.velocity_changes.empty()) return Vector3::Zero();
    const Vector3 went_on =
        xyz(equation.velocities[i]) + xyz(equation.velocity_changes[i]) / equation.divisor;
    return (xyz(equation.base_velocities[i]) - went_on) / equation.positions[i].w;
}

void BodyCoupling::reserve(std::size_t bodies, std::size_t cloths) {
    eliminated_.reserve(bodies);
    equations_.reserve(cloths);
}

void BodyCoupling::begin(std::span<MovingBody> bodies, std::span<const CarriedCollider> carried,
                         std::span<ColliderMotion> motions) {
    bodies_ = bodies;
    carried_ = carried;
    motions_ = motions;
    equations_.clear();
    eliminated_.assign(bodies.size(), Eliminated{});
    for (std::size_t k = 0; k < bodies.size(); ++k)
        eliminated_[k].departure = bodies[k].root.transpose() * bodies[k].expected;
    is_first_ = true;
}

template <class Visit>
void BodyCoupling::for_each_push(std::size_t cloth, const Visit& visit) const {
    const Contacts& contacts = *equations_[cloth]->contacts;
    for (const BodyPush& push : contacts.pushes()) visit(contacts, push);
}

void BodyCoupling::gather(std::size_t cloth, std::span<const Vec4> velocities) {
    const StepEquation& equation = *equations_[cloth];
    if (cloth == 0)
        for (Eliminated& body : eliminated_) {
            body.stiffness.setZero();
            body.pressed.setZero();
        }
    equation.contacts->find_pushes(equation, velocities);
    equation.contacts->find_stops(equation, velocities);
    for (const BodyStop& stop : equation.contacts->stops()) {
        Eliminated& body = eliminated_[stop.body];
        const Eigen::Vector3d arm = stop.arm.cast<double>();
        body.stiffness += at_arm(arm, stop.response.full());
        body.pressed += wrench(arm, stop.impulse.cast<double>());
    }
    for_each_push(cloth, [&](const Contacts& contacts, const BodyPush& push) {
        Eliminated& body = eliminated_[push.body];
        const std::uint32_t i = push.particle;
        const Eigen::Vector3d arm = push.arm.cast<double>();
        body.stiffness += at_arm(arm, contacts.rows().block(i).full());
        body.pressed += wrench(arm, contacts.of_colliders(i, xyz(velocities[i])).cast<double>());
        if (!is_first_) return;
        const Vector6 kept = wrench(arm, forgotten(equation, i).cast<double>());
        MovingBody& moving = bodies_[push.body];
        const Vector6 along_root = moving.root.transpose() * kept;
        moving.free -= moving.root * along_root;
        body.departure += along_root;  // it is where it was expected
    });
}

void BodyCoupling::eliminate() {
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        Eliminated& body = eliminated_[k];
        const MovingBody& moving = bodies_[k];
        const Matrix6 sum = Matrix6::Identity() + moving.root.transpose() * body.stiffness * moving.root;
        body.response = inverse_by_ldlt(sum);
        body.missing = -body.departure - moving.root.transpose() * body.pressed;
        body.extra = moving.root * (body.response * body.missing);
    }
    is_first_ = false;
}

void BodyCoupling::add_to_right_side(std::size_t cloth, std::span<Vec4> right_side) const {
    for_each_push(cloth, [&](const Contacts& contacts, const BodyPush& push) {
        const Vector3 v = velocity_at(eliminated_[push.body].extra, push.arm).cast<float>();
        Vec4& row = right_side[push.particle];
        set_xyz(row, xyz(row) + contacts.rows().block(push.particle) * v);
    });
}

void BodyCoupling::take(std::size_t cloth, std::span<const Vec4> x) {
    if (cloth == 0)
        for (Eliminated& body : eliminated_) body.sum.setZero();
    for_each_push(cloth, [&](const Contacts& contacts, const BodyPush& push) {
        const Vector3 pulled = contacts.rows().block(push.particle) * xyz(x[push.particle]);
        eliminated_[push.body].sum += wrench(push.arm.cast<double>(), pulled.cast<double>());
    });
}

double BodyCoupling::respond() {
    double sum = 0;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        Eliminated& body = eliminated_[k];
        const Matrix6& root = bodies_[k].root;
        body.answer = root * (body.response * (root.transpose() * body.sum));
        sum -= body.sum.dot(body.answer);
    }
    return sum;
}

void BodyCoupling::give(std::size_t cloth, std::span<Vec4> product) const {
    for_each_push(cloth, [&](const Contacts& contacts, const BodyPush& push) {
        const Vector3 v = velocity_at(eliminated_[push.body].answer, push.arm).cast<float>();
        Vec4& row = product[push.particle];
        set_xyz(row, xyz(row) - contacts.rows().block(push.particle) * v);
    });
}

void BodyCoupling::look(std::size_t cloth, std::span<const Vec4> velocities) {
    if (cloth == 0)
        for (Eliminated& body : eliminated_) body.sum.setZero();
    Contacts& contacts = *equations_[cloth]->contacts;
    for (BodyPush& push : contacts.pushes()) {
        const Vector3 v = xyz(velocities[push.particle]);
        const Vector3 pulled = contacts.rows().block(push.particle) * (v - push.velocity);
        push.velocity = v;
        eliminated_[push.body].sum += wrench(push.arm.cast<double>(), pulled.cast<double>());
    }
}

void BodyCoupling::follow() {
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        Eliminated& body = eliminated_[k];
        MovingBody& moving = bodies_[k];
        const Vector6 change = body.response * (body.missing + moving.root.transpose() * body.sum);
        body.missing.setZero();
        body.departure += change;
        body.answer = moving.root * change;
        moving.now += body.answer;
        moving.find_end();
    }
    move_colliders();
    for (std::size_t cloth = 0; cloth < equations_.size(); ++cloth) {
        Contacts& contacts = *equations_[cloth]->contacts;
        for (const BodyPush& push : contacts.pushes()) {
            const Vector3 v = velocity_at(eliminated_[push.body].answer, push.arm).cast<float>();
            contacts.add_impulse(push.particle, contacts.rows().block(push.particle) * v);
        }
    }
}

void BodyCoupling::move_colliders() {
    for (const CarriedCollider& collider : carried_)
        bodies_[collider.body].move(*collider.own, motions_[collider.motion]);
}

}  // namespace weft
