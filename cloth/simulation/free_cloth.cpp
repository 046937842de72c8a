#include "cloth/simulation/free_cloth.h"

#include <algorithm>
#include <limits>

#include "cloth/equation/pairs/pair_rows.h"
#include "cloth/equation/seam_rows.h"
#include "engine/small_matrices.h"

namespace weft {

namespace {

Eigen::Vector3d wide(const Vec4& v) {
    return xyz(v).cast<double>();
}

bool takes_part(const Cloth& cloth, std::size_t body) {
    return cloth.contacts && !cloth.collected[body].in_part.isZero(0);
}

/// Whether a particle, numbered as in pairs and seams, is one of this equation's cloth.
bool has_particle(const StepEquation& equation, std::uint32_t particle) {
    return (equation.pairs != nullptr || !equation.seams.empty()) &&
           particle - equation.first < equation.positions.size();
}

/// Cloths of an equation with the same label Cloth::free_with, and the bodies that got impulses from them.
class FreeTogether {
  public:
    FreeTogether(std::span<Cloth* const> cloths, std::span<const StepEquation> equations,
                 std::span<MovingBody> bodies, std::size_t number)
        : cloths_(cloths), equations_(equations), bodies_(bodies), number_(number) {}

    /// Labels every cloth that shares a body with a labelled one, or touches one.
    void grow() {
        for (bool any = true; any;) {
            any = false;
            for (std::size_t k = 0; k < cloths_.size(); ++k)
                if (cloths_[k]->free_with != number_ &&
                    (shares_body(*cloths_[k]) || touches_them(equations_[k]))) {
                    cloths_[k]->free_with = number_;
                    any = true;
                }
        }
    }
    /// visit(cloth, its equation)
    template <class Visit>
    void for_each_cloth(const Visit& visit) const {
        for (std::size_t k = 0; k < cloths_.size(); ++k)
            if (cloths_[k]->free_with == number_) visit(*cloths_[k], equations_[k]);
    }
    /// visit(body, impulse of the first cloth that gave it one)
    template <class Visit>
    void for_each_body(const Visit& visit) const {
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            bool is_first = true;
            for_each_cloth([&](Cloth& cloth, const StepEquation&) {
                if (is_first && takes_part(cloth, b)) {
                    is_first = false;
                    visit(bodies_[b], cloth.collected[b].in_part);
                }
            });
        }
    }
    /// Whether there is a body, and nothing else holds any of the cloths and bodies.
    [[nodiscard]] bool are_free() const {
        bool any_body = false, held = false;
        for_each_body([&](const MovingBody& body, const Vector6&) {
            any_body = true;
            held = held || body.inverse_mass == 0 || body.inverse_inertia.minCoeff() == 0;
        });
        for_each_cloth([&](const Cloth& cloth, const StepEquation& equation) {
            held = held || is_held(cloth) || touches_what_is_elsewhere(equation);
        });
        return any_body && !held;
    }

  private:
    [[nodiscard]] bool shares_body(const Cloth& cloth) const {
        bool shares = false;
        for (std::size_t b = 0; b < bodies_.size(); ++b)
            if (takes_part(cloth, b))
                for_each_cloth([&](const Cloth& other, const StepEquation&) {
                    shares = shares || takes_part(other, b);
                });
        return shares;
    }
    /// Whether features of the equation's cloth touch a particle that is_other, or a seam joins them.
    template <class IsOther>
    [[nodiscard]] static bool touches(const StepEquation& equation, const IsOther& is_other) {
        bool touches = false;
        const auto look = [&](const PairRows::ActivePair& active) {
            const auto is_own = [&](std::uint32_t particle) { return has_particle(equation, particle); };
            touches = touches || (std::ranges::any_of(active.pair.corners, is_own) &&
                                  std::ranges::any_of(active.pair.corners, is_other));
        };
        if (equation.pairs != nullptr) equation.pairs->for_each_active(look);
        for (const SeamRows* seam : equation.seams)
            seam->for_each_active_of(equation.first, equation.positions.size(), look);
        return touches;
    }
    [[nodiscard]] bool touches_them(const StepEquation& equation) const {
        return touches(equation, [&](std::uint32_t particle) {
            bool is_theirs = false;
            for_each_cloth([&](const Cloth&, const StepEquation& their) {
                is_theirs = is_theirs || has_particle(their, particle);
            });
            return is_theirs;
        });
    }
    /// Whether the equation's cloth touches cloth of other equations, which then holds it.
    [[nodiscard]] bool touches_what_is_elsewhere(const StepEquation& equation) const {
        return touches(equation, [&](std::uint32_t particle) {
            return std::ranges::none_of(equations_,
                                        [&](const StepEquation& one) { return has_particle(one, particle); });
        });
    }
    [[nodiscard]] static bool is_held(const Cloth& cloth) {
        if (!cloth.contacts || !cloth.contacts->stops().empty() || !cloth.state.pins.empty() ||
            cloth.model.component_offsets.size() != 2)
            return true;
        for (std::uint32_t i = 0; i < cloth.state.size(); ++i)
            if (cloth.contacts->presses_collider(i) && cloth.body_buffers.pressed[i] < 0) return true;
        return false;
    }

    std::span<Cloth* const> cloths_;
    std::span<const StepEquation> equations_;
    std::span<MovingBody> bodies_;
    std::size_t number_;
};

/// Mass, momentum and inertia of particles and bodies at the end of the part, by their present velocities.
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

Motion motion_of(const FreeTogether& free) {
    Motion sum;
    free.for_each_cloth([&](const Cloth& cloth, const StepEquation& equation) {
        for_each_free(equation, [&](std::uint32_t i, double m) {
            const Eigen::Vector3d v = wide(cloth.scratch_velocities[i]);
            sum.add(m, place(equation, i, v), v);
        });
    });
    return sum;
}

Vector6 momentum_of(const Motion& motion) {
    Vector6 sum;
    sum << motion.linear, motion.angular;
    return sum;
}

/// The rigid velocity change, of the common centre and about it, for a momentum gained about the origin.
Vector6 as_one(const Motion& all, const Vector6& gained) {
    const Eigen::Vector3d centre = all.centre / all.mass;
    const Eigen::Matrix3d about_centre =
        all.inertia -
        all.mass * (centre.squaredNorm() * Eigen::Matrix3d::Identity() - centre * centre.transpose());
    const Eigen::Vector3d linear = gained.head<3>(), angular = gained.tail<3>() - centre.cross(linear);
    Vector6 change;
    change << linear / all.mass,
        solve_by_ldlt(about_centre + 1e-9 * about_centre.trace() * Eigen::Matrix3d::Identity(), angular);
    return change;
}

/// The momentum and angular momentum that the cloths should have when the part ends.
Vector6 owed(const FreeTogether& free, std::span<const MovingBody> bodies) {
    Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = linear, echo = linear, outside = linear,
                    torque = linear, centre = linear;
    double mass = 0, ratio = 1;
    Vector6 of_bodies = Vector6::Zero();
    free.for_each_cloth([&](const Cloth& cloth, const StepEquation& equation) {
        ratio = static_cast<double>(equation.h / equation.gamma);
        for_each_free(equation, [&](std::uint32_t i, double m) {
            const Eigen::Vector3d v = wide(equation.velocities[i]), x = wide(equation.positions[i]);
            linear += m * v;
            angular += m * x.cross(v);
            const ExternalRow row = external_row(equation, i);
            const Eigen::Vector3d solved = wide(cloth.scratch_velocities[i]),
                                  there = place(equation, i, solved);
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
        for (std::size_t k = 0; k < bodies.size(); ++k) {
            const Vector6& given = cloth.collected[k].in_part;
            // With its motion over the part, a body's angular momentum changes as by an impulse here.
            const Eigen::Vector3d at = bodies[k].end.position.cast<double>() -
                                       static_cast<double>(equation.gamma) * bodies[k].velocity.head<3>();
            of_bodies.head<3>() += given.head<3>();
            of_bodies.tail<3>() += given.tail<3>() + at.cross(Eigen::Vector3d(given.head<3>()));
            for (int axis = 0; axis < 3; ++axis)
                echo[axis] +=
                    static_cast<double>(cloth.state.shares[k].echo[static_cast<std::size_t>(axis)]) /
                    static_cast<double>(equation.divisor);
        }
    });
    centre /= mass;
    const Eigen::Vector3d by_outside = outside + echo;
    torque += centre.cross(by_outside - ratio * outside);
    Vector6 sum;
    sum << linear + by_outside, angular + torque;
    return sum - of_bodies;
}

void keep_momentum(const FreeTogether& free, std::span<const MovingBody> bodies) {
    const Vector6 missing = owed(free, bodies) - momentum_of(motion_of(free));
    const auto motion_of_all = [&] {
        Motion all = motion_of(free);
        free.for_each_body([&](const MovingBody& body, const Vector6&) { all.add(body); });
        return all;
    };
    const Vector6 target = missing + momentum_of(motion_of_all());
    constexpr int rounds = 3;  // the change also moves the ends, by which momentum is measured
    for (int round = 0; round < rounds; ++round) {
        const Motion all = motion_of_all();
        const Vector6 change = as_one(all, target - momentum_of(all));
        if (!change.allFinite()) return;
        const Eigen::Vector3d centre = all.centre / all.mass, turn = change.tail<3>();
        const auto change_at = [&](const Eigen::Vector3d& place) -> Eigen::Vector3d {
            return change.head<3>() + turn.cross(place - centre);
        };
        free.for_each_cloth([&](Cloth& cloth, const StepEquation& equation) {
            for_each_free(equation, [&](std::uint32_t i, double /*m*/) {
                Vec4& velocity = cloth.scratch_velocities[i];
                const Eigen::Vector3d v = wide(velocity);
                velocity = to_vec4((v + change_at(place(equation, i, v))).cast<float>(), 0);
            });
        });
        free.for_each_body([&](MovingBody& body, Vector6& given) {
            Vector6 its;
            its << change_at(body.end.position.cast<double>()), turn;
            given.head<3>() += its.head<3>() / body.inverse_mass;
            given.tail<3>() += body.inertia() * turn;
            body.now += its;
            body.find_end();
        });
    }
}

}  // namespace

void keep_momentum_with_bodies(std::span<Cloth* const> cloths, std::span<const StepEquation> equations,
                               std::span<MovingBody> bodies) {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    const auto gave_any = [&](const Cloth& cloth) {
        for (std::size_t b = 0; b < bodies.size(); ++b)
            if (takes_part(cloth, b)) return true;
        return false;
    };
    for (Cloth* cloth : cloths) cloth->free_with = none;
    for (std::size_t k = 0; k < cloths.size(); ++k) {
        if (cloths[k]->free_with != none || !gave_any(*cloths[k])) continue;
        FreeTogether free(cloths, equations, bodies, k);
        cloths[k]->free_with = k;
        free.grow();
        if (free.are_free()) keep_momentum(free, bodies);
    }
}

}  // namespace weft
