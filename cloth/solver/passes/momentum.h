#pragma once
// Momentum of what nothing holds. Few iterations leave a part of it unsolved.

#include <cstdint>
#include <span>

#include "cloth/equation/step_equation.h"
#include "cloth/mesh/cook.h"
#include "engine/memory/hooked_vector.h"

namespace weft {

/// Sums over the particles of a piece. All pieces share the point that places are told from. m is a
/// particle's mass, v its velocity and d its place at the end of the step, r its row sum, and q the change of
/// v that would satisfy external forces alone.
struct PieceSums {
    using Vector = Eigen::Vector3d;
    using Matrix = Eigen::Matrix3d;
    /// Motion at the start or at the end of the step.
    struct Motion {
        Vector first = Vector::Zero();     ///< sum m d [kg m]
        Vector momentum = Vector::Zero();  ///< sum m v [kg m/s]
        double energy = 0;                 ///< sum m v^2 / 2 [J]
        Matrix spread = Matrix::Zero();    ///< sum m d v^T [kg m^2/s]
    };

    double row_sum = 0;               ///< sum r [kg]
    Vector first = Vector::Zero();    ///< sum r d [kg m]
    Matrix second = Matrix::Zero();   ///< sum r d d^T [kg m^2]
    Vector missing = Vector::Zero();  ///< momentum: sum r q [kg m/s]
    double mass = 0;                  ///< sum m [kg]
    Motion start, end;
    Vector impulse = Vector::Zero();  ///< impulse of external forces [N s]
    Vector turning = Vector::Zero();  ///< sum d x that impulse [N m s]

    void add(const PieceSums& more);
};

/// The change that gives a piece what it lacks: v becomes share v + velocity + spin x d, and each place
/// changes by gamma times as much.
struct RigidChange {
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), spin = Eigen::Vector3d::Zero();
    double share = 1;

    RigidChange() = default;
    RigidChange(const PieceSums& sums, float gamma);
};

/// Components of one cloth. Internal forces and contact between features add up to nothing, so external
/// forces alone decide the momentum of a component at the end of a step, and its angular momentum.
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
        bool touches = false;  ///< features of its own or of others, or is joined to them by a seam
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
