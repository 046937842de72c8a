#pragma once
// Momentum of what nothing holds. Few iterations leave a part of it unsolved.

#include <cstdint>
#include <span>

#include "cloth/equation/step_equation.h"
#include "cloth/mesh/cook.h"
#include "engine/memory/hooked_vector.h"

namespace weft {

/// Sums over particles of a piece, about a point that all pieces share. r is a particle's row sum, d its
/// place at the end of the step, q how much its velocity lacks against external forces alone.
struct PieceSums {
    double mass = 0;                                    ///< sum r [kg]
    Eigen::Vector3d first = Eigen::Vector3d::Zero();    ///< sum r d [kg m]
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();   ///< sum r d d^T [kg m^2]
    Eigen::Vector3d missing = Eigen::Vector3d::Zero();  ///< momentum: sum r q [kg m/s]
    Eigen::Vector3d torque = Eigen::Vector3d::Zero();   ///< angular momentum: sum d x r q [kg m^2/s]

    void add(double r, const Eigen::Vector3d& d, const Eigen::Vector3d& q);
    void add(const PieceSums& more);
};

/// The rigid motion that gives a piece what it lacks: q = velocity + spin x d.
struct RigidChange {
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), spin = Eigen::Vector3d::Zero();

    RigidChange() = default;
    explicit RigidChange(const PieceSums& sums);
};

/// Components of one cloth. Internal forces and contact between features add up to nothing, in momentum and
/// in angular momentum (a particle's torque is taken where it ends the step), so what external forces do to a
/// component is known before anything is solved.
class FreePieces {
  public:
    explicit FreePieces(const ClothModel& model);
    [[nodiscard]] std::uint32_t particles() const noexcept { return model_->particle_count; }
    /// Makes room for contact of features; of no pairs, frees it.
    void reserve_pairs(std::size_t count);

    /// Weighs the components that nothing holds, at solved velocities, about `origin`.
    void weigh(const StepEquation& equation, std::span<const Vec4> velocities, const Vector3& origin);
    /// Adds up the components that touch features of others or their own. Returns whether one is held.
    bool add_touching(PieceSums& sums) const;
    /// Gives each free component what it lacks, and those that touch the motion of all of them.
    void move(const StepEquation& equation, const RigidChange& of_touching, const Vector3& origin,
              std::span<Vec4> velocities) const;
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    struct Piece {
        bool touches = false;  ///< features of its own or of others
        bool is_held = false;  ///< by a pin, a collider or a body
        PieceSums sums;
    };
    [[nodiscard]] std::span<const std::uint32_t> particles_of(std::size_t component) const;
    void mark_touching(const StepEquation& equation);

    const ClothModel* model_;
    HookedVector<std::uint32_t> component_of_;  // of particles, only with features
    HookedVector<Piece> pieces_;
};

}  // namespace weft
