#pragma once
// A scene: its content in the world, its motion, its camera and its check.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "demo/character/garment/map_names.h"
#include "demo/character/garment/surface_parts.h"
#include "demo/window/annotation.h"
#include "weft/render/camera.h"
#include "weft/render/scene_renderer.h"
#include "weft/weft.h"

namespace weft::demo {

/// The part of a garment that is pinned.
enum class Hold { highest_opening, top, border, nothing };

struct SceneOptions {
    std::uint32_t particles = 0;        ///< about this many; 0: the scene's own number
    std::filesystem::path garment{};    ///< OBJ file, for scenes that take one
    std::filesystem::path motion{};     ///< BVH file or pipe, for scenes that take one
    double speed = 1;                   ///< factor on the motion's own speed
    bool skin = false;                  ///< garments collide with the body's skin, not capsules
    Hold hold = Hold::highest_opening;  ///< of the scene garment
    bool y_is_up = false;               ///< up in the garment's file is +Y; else +Z
    float unit = 0;  ///< metres in a unit of the garment's file; 0: a garment's size decides
    /// About how many particles a proxy (weft/proxy.h) of a file's garment has, over which the garment's own
    /// mesh is drawn; 0: the mesh itself is simulated.
    std::uint32_t simulated = 0;

    [[nodiscard]] std::uint32_t particles_or(std::uint32_t usual) const {
        return particles == 0 ? usual : particles;
    }
};

/// A cloth of the scene, with its data for drawing.
struct SceneCloth {
    ClothId id;
    Mesh mesh;
    render::FabricLook look;
    SurfaceParts surface{};  ///< colours by material of the drawn triangles; empty: the look's
    Mesh fine{};             ///< drawn in place of the mesh, where `drawn` is set
    std::shared_ptr<const DrawnMesh> drawn{};  ///< how `fine` follows the cloth
    std::vector<PaintedMap> maps{};            ///< the cloth's, which a brush may change
    std::vector<Vec4> tints{};  ///< by vertex, as render::ClothFrame::colours; empty: the look's alone
};

/// Draws a finer mesh in place of the cloth, from the pose in which both are now. Error: DrawnMesh::bind()'s.
[[nodiscard]] Result<void> draw_over(SceneCloth& cloth, const World& world, const Mesh& fine,
                                     const DrawnMeshSettings& binding = {});

/// The colour of drawn colliders: slate, neither the ground's nor any cloth's.
inline constexpr Vec3 collider_colour{0.30f, 0.36f, 0.46f};

/// A look whose back is paler than its front.
[[nodiscard]] render::FabricLook two_sided(const Vec3& front, float stripe_width = 0);

/// The moment at which a solid is placed: after the last step, or before it, where pictures in between need
/// both.
enum class SolidMoment { now, before_last_step };

/// A solid of triangles in the scene.
struct SceneSolid {
    Mesh mesh;  ///< in the world; shared vertices are shaded smoothly
    Vec3 colour;
    std::function<void(std::span<Vec3>, SolidMoment)> place{};  ///< writes vertices; empty: it keeps still
    std::vector<Vec4> tints{};                                  ///< as SceneCloth::tints
};

/// The result of build(), for the program that shows the scene.
struct SceneContent {
    std::vector<SceneCloth> cloths;
    std::vector<ColliderId> drawn_colliders;  ///< balls, capsules and boxes to draw; planes are the ground
    std::vector<ColliderId> clad_colliders;   ///< those that a solid is drawn in place of
    std::vector<SceneSolid> solids;
    std::vector<std::string> notes{};  ///< for the user: what the scene has made of a file
    render::OrbitCamera camera;
    float ground_height = 0;  ///< of the drawn ground [m]; below where cloth without weight may go
};

class Scene {
  public:
    virtual ~Scene() = default;

    /// Wind, substeps and gravity that the scene starts with; threads and executor are the program's.
    [[nodiscard]] virtual WorldSettings world_settings() const { return {}; }
    /// Adds cloths, pins and colliders to an empty world. Error, or Refusal: why something could not be
    /// built.
    [[nodiscard]] virtual Result<SceneContent> build(World& world, const SceneOptions& options) = 0;
    /// Moves pins and colliders before the step from `time` to `time + dt` [s].
    virtual void before_step(World& world, double time, float dt);
    /// The World was restored to its state at that time [s]: what is drawn without it goes there, too.
    virtual void go_to(double time);
    /// Called after before_step(): cuts cloth, in the content as well. True: cloth was cut.
    virtual bool cut_before_step(World& world, SceneContent& content);

    /// Gives a cloth a skin, to which leashes refer (World::set_skin). Error: nobody wears it.
    [[nodiscard]] virtual Result<void> give_skin(World& world, ClothId cloth);

    /// Adds words, lines and solids that show the world's present state and what holds its cloth.
    virtual void annotate(const World& /*world*/, Annotation& /*to*/) const {}

    /// The scene's own test: after this many steps of 1/60 s ...
    [[nodiscard]] virtual int check_steps() const { return 300; }
    /// ... this must hold. Error: the condition that fails, with its value.
    [[nodiscard]] virtual Result<void> check(const World& world) const = 0;
};

/// A group of scenes in the gallery. The scenes of `lab` share one card there: they are experiments of
/// contact.
enum class SceneGroup { wind, play, wear, meet, learn, lab };

/// One line of the registry.
struct SceneEntry {
    const char* name;
    const char* description;  ///< one sentence
    std::unique_ptr<Scene> (*make)();
    SceneGroup group;
    bool needs_garment = false;          ///< cannot be built without SceneOptions::garment
    bool takes_garment = needs_garment;  ///< can be built with one
    bool takes_motion = false;           ///< uses SceneOptions::motion, speed and skin
};

/// All scenes, in the order in which they are listed. scenes/registry.cpp holds one line for each.
[[nodiscard]] std::span<const SceneEntry> all_scenes();
/// The scene of that name; null if there is none.
[[nodiscard]] const SceneEntry* find_scene(std::string_view name);

}  // namespace weft::demo
