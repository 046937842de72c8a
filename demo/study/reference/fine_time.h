#pragma once
// The truth: the same cloth in double precision, in time steps so small that their error does not matter.

#include <array>
#include <cstdint>
#include <vector>

#include "cloth/mesh/cook.h"
#include "demo/study/run.h"
#include "engine/threads/parallel_blocks.h"

namespace weft::study {

/// Velocity Verlet with velocities predicted for the damping forces (Groot and Warren 1997, with lambda = 1),
/// which is second order at one evaluation of forces a step:
///     x' = x + h v + h^2/2 a,   a' = f(x', v + h a) / m,   v' = v + h/2 (a + a')
/// With damping rate c it is stable for h c < 1, without for h omega < 2.
class FineTime {
  public:
    static constexpr std::uint32_t lanes = 8;  ///< particles that are computed together

    /// Starts with the scene's cloth as Run places it before its first frame. No method is involved.
    FineTime(const StudyScene& scene, int threads);

    /// Advances by one frame in `substeps` steps.
    void step(int substeps);
    /// Steps a frame that are safely stable for the scene, and at least 64.
    [[nodiscard]] static int safe_substeps(const StudyScene& scene);

    [[nodiscard]] std::vector<Eigen::Vector3d> positions() const;
    [[nodiscard]] std::vector<Eigen::Vector3d> velocities() const;

  private:
    using Component = std::vector<double>;  // of all particles, padded to whole groups
    using Components = std::array<Component, 3>;

    void make_springs(const ClothModel& model, const Fabric& fabric);
    [[nodiscard]] std::vector<Eigen::Vector3d> vectors(const Components& components) const;
    void predict(double h);
    void compute_air();
    void finish(double h);

    Parallel parallel_;
    double frame_, damping_, air_damping_;
    Eigen::Vector3d gravity_;
    Wind wind_;
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> corner_offsets_, corner_triangles_;
    std::vector<std::uint32_t> group_slots_, neighbours_;     // [slot * lanes + lane]
    std::vector<double> stiffness_, rest_lengths_, bending_;  // 0, 1 and 0 as padding of unused slots
    std::uint32_t particles_;
    Component inverse_masses_;  // 0: pinned
    Components x_, v_, predicted_, a_, air_;
    std::vector<Eigen::Vector3d> triangle_forces_;
};

}  // namespace weft::study
