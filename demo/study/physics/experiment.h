#pragma once
// Strips of cloth to be tested, as sheets and as meshes of triangles, and one cloth in a World of its own.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "weft/weft.h"

namespace weft::study {

/// The model of the fabric's stiffness, and its mesh.
enum class ForceModel {
    sheet,     ///< springs along a sheet's threads
    mesh,      ///< springs along the edges of a general mesh
    elements,  ///< finite elements on that mesh
};
inline constexpr std::array force_models{ForceModel::sheet, ForceModel::mesh, ForceModel::elements};
[[nodiscard]] const char* name_of(ForceModel model);

/// Settings without air damping, with the default method. Tests change what they need.
[[nodiscard]] ClothSettings made_of(ForceModel model, const Fabric& fabric);

/// Maps a point of the pattern to space.
using Place = std::function<Vec3(Vec2)>;

/// A rectangle [0, length] x [0, width] of the pattern, warp along the length, in `cells` columns along it:
/// as a sheet of nearly square cells, or of nearly equilateral triangles with straight columns. The pattern
/// is its rest shape.
struct Strip {
    double length = 1, width = 1;
    std::uint32_t cells = 16;
};
[[nodiscard]] Mesh strip_mesh(ForceModel model, const Strip& strip, const Place& place);

/// A pseudo-random value from -1 to 1, always the same for the same `number`.
[[nodiscard]] float noise(std::uint32_t number);

// One cloth in a World of its own, through the interface that a host has.

/// World settings without air, for one thread.
[[nodiscard]] WorldSettings in_vacuum(const Vec3& gravity = {0, -9.81f, 0});

class Experiment {
  public:
    static constexpr double gravity = 9.81;         ///< [m/s^2]
    static constexpr float usual_step = 1.0f / 60;  ///< [s]

    /// One cloth, by default in a vacuum. Throws std::runtime_error where a World refuses it or its settings.
    Experiment(Mesh mesh, const ClothSettings& cloth, const WorldSettings& settings = in_vacuum());

    void pin(const std::function<bool(Vec2)>& of_the_pattern);
    void step(float seconds = usual_step) { world_.step(seconds); }
    /// Steps for this time, rounded to whole steps. `each` is called after every step.
    void run(double seconds, float step = usual_step, const std::function<void()>& each = {});
    /// Steps until nothing moves faster than `still` [m/s], with velocities decaying at `damping` [1/s].
    /// False: something still did after `most_seconds`.
    bool come_to_rest(double damping, double most_seconds = 30, float still = 2e-6f);

    [[nodiscard]] World& world() { return world_; }
    [[nodiscard]] ClothId cloth() const { return cloth_; }
    void change(const std::function<void(ClothSettings&)>& how);
    void change_world(const std::function<void(WorldSettings&)>& how);

    [[nodiscard]] const Mesh& mesh() const { return mesh_; }
    [[nodiscard]] Vec3 at(std::uint32_t vertex) const;        ///< [m]
    [[nodiscard]] Vec3 velocity(std::uint32_t vertex) const;  ///< [m/s]
    [[nodiscard]] double mass(std::uint32_t vertex) const;    ///< of its particle [kg]; 0 where it is pinned
    /// The vertices whose place in the pattern satisfies the predicate.
    [[nodiscard]] std::vector<std::uint32_t> vertices(const std::function<bool(Vec2)>& of_the_pattern) const;
    /// Mean position of these vertices [m].
    [[nodiscard]] Vec3 mean_place(const std::vector<std::uint32_t>& vertices) const;
    /// Kinetic and gravitational energy (0 at y = 0) of all free particles [J].
    [[nodiscard]] double energy() const;
    [[nodiscard]] double rms_speed() const;  ///< weighted by mass [m/s]

  private:
    Mesh mesh_;
    World world_;
    ClothId cloth_;
};

}  // namespace weft::study
