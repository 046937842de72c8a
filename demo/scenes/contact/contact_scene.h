#pragma once
// A scene in which cloth collides with cloth, as plain data that the demo shows and the study judges.

#include <cstdint>
#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "demo/scenes/solids.h"
#include "weft/weft.h"

namespace weft::demo {

class Scene;

/// A cloth of a scene. If the mesh has a pattern, the pattern is its rest shape.
struct PlacedCloth {
    Mesh mesh;
    ClothSettings settings{};
    std::vector<std::uint32_t> pins{};  ///< vertices held from the start
    /// The first vertex of each layer, the lowest layer first; a layer ends before the next begins. Empty:
    /// the order of layers is not judged.
    std::vector<std::uint32_t> layers{};
};

/// Moves a scene's cloths and colliders before each step. They are named by their indices in its lists.
class SceneHandles {
  public:
    virtual void move_pin(std::size_t cloth, std::uint32_t vertex, const Vec3& target) const = 0;
    virtual void unpin(std::size_t cloth, const std::vector<std::uint32_t>& vertices) const = 0;
    virtual void move_collider(std::size_t collider, const Collider& target) const = 0;

  protected:
    ~SceneHandles() = default;
};

/// The holder that is drawn where a scene holds a cloth.
struct DrawnHolder {
    std::size_t cloth;
    Holder holder;
    std::vector<std::uint32_t> vertices;
};

struct ContactScene {
    std::string name;
    double seconds = 0;
    std::vector<PlacedCloth> cloths{};
    std::vector<Collider> colliders{};
    WorldSettings world{};
    /// Moves pins and colliders to their places at `time` [s], the end of the step that follows.
    std::function<void(const SceneHandles&, double time)> move{};
    std::vector<DrawnHolder> holders{};
    bool tangled = false;  ///< triangles cross at the start
    bool rests = false;    ///< at its end nothing is moved, and cloth should be still
    /// Sum of mass times speed [kg m/s] in a scene without external forces; 0: there are some.
    double free_momentum = 0;
    /// Time from which momentum should be conserved [s].
    double free_from = 0;
    [[nodiscard]] static constexpr double step() { return 1.0 / 60; }
};

/// Makes a scene, by its name, of about `particles` particles (0: its own number).
struct SceneMaker {
    std::string name;
    bool quick;  ///< whether `--quick` runs it
    std::function<ContactScene(std::uint32_t particles)> make;
    bool needs_garments = false;
};

/// Number of particles, about, of a scene that `--quick` runs.
inline constexpr std::uint32_t quick_contact_particles = 1000;

/// The scenes of one file each.
[[nodiscard]] std::vector<SceneMaker> fold_scenes();
[[nodiscard]] std::vector<SceneMaker> stack_scenes();
[[nodiscard]] std::vector<SceneMaker> drape_scenes();
[[nodiscard]] std::vector<SceneMaker> forced_scenes();
[[nodiscard]] std::vector<SceneMaker> meeting_scenes();
[[nodiscard]] std::vector<SceneMaker> tangle_scenes();

/// The scenes that are only shown.
[[nodiscard]] std::vector<SceneMaker> shown_scenes();

/// The camera of a scene on the demo's stage, relative to a view of all cloth at the start.
struct StageView {
    float nearer = 1;  ///< factor by which the camera is nearer than for all of it
    float lower = 0;   ///< [m]
    int check_steps = 90;
    /// Damping of the fabric [s] and by the air [1/s] that a scene needs for its pleats to rest; 0: its own.
    float damping = 0, air_damping = 0;
};
/// A scene of contact as a scene of the demo. Precondition: there is one of that name.
[[nodiscard]] std::unique_ptr<Scene> make_contact_stage(std::string_view name, const StageView& view);

/// All scenes but those that are only shown.
[[nodiscard]] std::vector<SceneMaker> contact_scenes();

// Sheets placed in space, from which scenes are made.

/// Maps a point of the pattern, u along the length and v along the width [m], to space.
using PlaceOf = std::function<Eigen::Vector3d(double u, double v)>;

/// A sheet `length` by `width` [m], its rows along the length, with the flat pattern as its rest shape.
struct Piece {
    double length, width;
    std::uint32_t columns, rows;  ///< particles along length and width
    [[nodiscard]] double edge() const { return length / (columns - 1); }
};
/// A piece of about `particles` particles in squares. columns - 1 is a multiple of `parts`, so that folds can
/// be between cells.
[[nodiscard]] Piece piece(double length, double width, std::uint32_t particles, std::uint32_t parts = 1);
[[nodiscard]] Mesh placed_sheet(const Piece& piece, const PlaceOf& place);
/// A vertex of the piece's sheet.
[[nodiscard]] inline std::uint32_t vertex_at(const Piece& piece, std::uint32_t row, std::uint32_t column) {
    return row * piece.columns + column;
}
[[nodiscard]] std::vector<std::uint32_t> column_of(const Piece& piece, std::uint32_t column);

/// Sheets of squares as one general mesh; their first vertices are the layers.
[[nodiscard]] PlacedCloth joined(const std::vector<Mesh>& sheets);

/// The default distance of self-collision for a mesh of edges of this length [m].
[[nodiscard]] double usual_distance(double edge);

/// `particles`, or where that is 0, a scene's own number.
[[nodiscard]] inline std::uint32_t or_else(std::uint32_t particles, std::uint32_t usual) {
    return particles == 0 ? usual : particles;
}

/// A scene's sheets are one cloth, or several of one World.
enum class Made { one_mesh, cloths };
[[nodiscard]] std::string named(const std::string& name, Made made);
[[nodiscard]] std::vector<PlacedCloth> layered(const std::vector<Mesh>& sheets, Made made);

/// A sheet that lies level, turned about its middle, which is over the origin.
[[nodiscard]] Mesh level_sheet(const Piece& sheet, double height, double turn);

/// World settings with still air.
[[nodiscard]] WorldSettings still_air();
/// World settings without air and gravity; cloth in this World should have no air_damping.
[[nodiscard]] WorldSettings zero_gravity();
[[nodiscard]] Collider ground();
[[nodiscard]] Vec3 to_point(const Eigen::Vector3d& p);

}  // namespace weft::demo
