#include "cloth/simulation/free_cloth.h"

#include <algorithm>
#include <Eigen/Cholesky>

namespace weft {

namespace {

Eigen::Vector3d wide(const Vec4& v) {
    return xyz(v).cast<double>();
}

bool takes_part(const Cloth& cloth, std::size_t body) {
    return !cloth.collected[body].in_part.isZero(0);
}

bool is_free_but_for_bodies(const Cloth& cloth, const StepEquation& equation,
                            std::span<const MovingBody> bodies) {
    if (!cloth.contacts->stops().empty()) return false;
    if (!cloth.state.pins.empty() || equation.pairs != nullptr || cloth.model.component_offsets.size() != 2)
        return false;
    bool any = false;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        if (!takes_part(cloth, k)) continue;
        if (bodies[k].inverse_mass == 0 || bodies[k].inverse_inertia.minCoeff() == 0) return false;
        any = true;
    }
    if (!any) return false;
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i)
        if (cloth.contacts->presses_collider(i) && cloth.body_buffers.pressed[i] < 0) return false;
    return true;
}

/// Of the cloth when the part ends, at what velocities are now.
struct Motion {
    double mass = 0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [m]
    Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the origin [kg m^2]

    void add(double m, const Eigen::Vector3d& x, const Eigen::Vector3d& v) {
        mass += m;
        centre += m * x;
        linear += m * v;
        angular += m * x.cross(v);
        inertia += m * (x.squaredNorm() * Eigen::Matrix3d::Identity() - x * x.transpose());
    }
    void add(const MovingBody& body) {
        add(1 / body.inverse_mass, body.end.position.cast<double>(), body.now.head<3>());
        angular += body.inertia() * body.now.tail<3>();
        inertia += body.inertia();
    }
};

Eigen::Vector3d place(const StepEquation& equation, std::uint32_t i, const Eigen::Vector3d& v) {
    return wide(equation.base_positions[i]) + static_cast<double>(equation.gamma) * v;
}

template <class Visit>
void for_each_free(const StepEquation& equation, const Visit& visit) {
    for (std::uint32_t i = 0; i < equation.positions.size(); ++i)
        if (equation.positions[i].w > 0) visit(i, 1 / static_cast<double>(equation.positions[i].w));
}

Motion motion_of(const StepEquation& equation, std::span<const Vec4> velocities) {
    Motion sum;
    for_each_free(equation, [&](std::uint32_t i, double m) {
        const Eigen::Vector3d v = wide(velocities[i]);
        sum.add(m, place(equation, i, v), v);
    });
    return sum;
}

Vector6 momentum_of(const Motion& motion) {
    Vector6 sum;
    sum << motion.linear, motion.angular;
    return sum;
}

/// The velocity, of the common centre and about it, that all of it gains by this momentum about the origin.
Vector6 as_one(const Motion& all, const Vector6& gained) {
    const Eigen::Vector3d centre = all.centre / all.mass;
    const Eigen::Matrix3d about_centre =
        all.inertia -
        all.mass * (centre.squaredNorm() * Eigen::Matrix3d::Identity() - centre * centre.transpose());
    const Eigen::Vector3d linear = gained.head<3>(), angular = gained.tail<3>() - centre.cross(linear);
    Vector6 change;
    change << linear / all.mass,
        (about_centre + 1e-9 * about_centre.trace() * Eigen::Matrix3d::Identity()).ldlt().solve(angular);
    return change;
}

/// What the cloth should have when the part ends.
Vector6 owed(const Cloth& cloth, const StepEquation& equation, std::span<const MovingBody> bodies,
             std::span<const Vec4> velocities) {
    Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = linear, echo = linear, outside = linear,
                    torque = linear, centre = linear;
    double mass = 0;
    const double ratio = static_cast<double>(equation.h / equation.gamma);
    for_each_free(equation, [&](std::uint32_t i, double m) {
        const Eigen::Vector3d v = wide(equation.velocities[i]), x = wide(equation.positions[i]);
        linear += m * v;
        angular += m * x.cross(v);
        const ExternalRow row = external_row(equation, i);
        const Eigen::Vector3d solved = wide(velocities[i]), there = place(equation, i, solved);
        const Eigen::Vector3d impulse =
            static_cast<double>(row.row_sum) * (row.free_velocity.cast<double>() - solved) +
            m * (solved - wide(equation.base_velocities[i]));
        outside += impulse;
        torque += ratio * there.cross(impulse);
        if (!equation.velocity_changes.empty())
            echo += m / static_cast<double>(equation.divisor) * wide(equation.velocity_changes[i]);
        centre += m * there;
        mass += m;
    });
    centre /= mass;
    Vector6 of_bodies = Vector6::Zero();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const Vector6& given = cloth.collected[k].in_part;
        // The angular momentum of a body that came so to its end has changed by that of an impulse there.
        const Eigen::Vector3d at = bodies[k].end.position.cast<double>() -
                                   static_cast<double>(equation.gamma) * bodies[k].velocity.head<3>();
        of_bodies.head<3>() += given.head<3>();
        of_bodies.tail<3>() += given.tail<3>() + at.cross(Eigen::Vector3d(given.head<3>()));
        for (int axis = 0; axis < 3; ++axis)
            echo[axis] += static_cast<double>(cloth.state.shares[k].echo[static_cast<std::size_t>(axis)]) /
                          static_cast<double>(equation.divisor);
    }
    const Eigen::Vector3d by_outside = outside + echo;
    torque += centre.cross(by_outside - ratio * outside);
    Vector6 sum;
    sum << linear + by_outside, angular + torque;
    return sum - of_bodies;
}

}  // namespace

void keep_momentum_with_bodies(Cloth& cloth, const StepEquation& equation, std::span<MovingBody> bodies) {
    if (!is_free_but_for_bodies(cloth, equation, bodies)) return;
    const std::span<Vec4> velocities = cloth.scratch_velocities.span();
    const Vector6 missing =
        owed(cloth, equation, bodies, velocities) - momentum_of(motion_of(equation, velocities));
    const auto for_each_body = [&](const auto& visit) {
        for (std::size_t k = 0; k < bodies.size(); ++k)
            if (takes_part(cloth, k)) visit(bodies[k], cloth.collected[k].in_part);
    };
    const auto motion_of_all = [&] {
        Motion all = motion_of(equation, velocities);
        for_each_body([&](const MovingBody& body, const Vector6&) { all.add(body); });
        return all;
    };
    const Vector6 target = missing + momentum_of(motion_of_all());
    constexpr int rounds = 3;  // since what moves ends elsewhere
    for (int round = 0; round < rounds; ++round) {
        const Motion all = motion_of_all();
        const Vector6 change = as_one(all, target - momentum_of(all));
        if (!change.allFinite()) return;
        const Eigen::Vector3d centre = all.centre / all.mass, turn = change.tail<3>();
        const auto change_at = [&](const Eigen::Vector3d& place) -> Eigen::Vector3d {
            return change.head<3>() + turn.cross(place - centre);
        };
        for_each_free(equation, [&](std::uint32_t i, double /*m*/) {
            const Eigen::Vector3d v = wide(velocities[i]);
            velocities[i] = to_vec4((v + change_at(place(equation, i, v))).cast<float>(), 0);
        });
        for_each_body([&](MovingBody& body, Vector6& given) {
            Vector6 its;
            its << change_at(body.end.position.cast<double>()), turn;
            given.head<3>() += its.head<3>() / body.inverse_mass;
            given.tail<3>() += body.inertia() * turn;
            body.now += its;
            body.find_end();
        });
    }
}

}  // namespace weft
