#pragma once
// A scene: what stands in the world, what moves it, how to look at it, and how to tell that it went right.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "demo/window/annotation.h"
#include "weft/render/camera.h"
#include "weft/render/scene_renderer.h"
#include "weft/weft.h"

namespace weft::demo {

/// What of a garment stays where it is.
enum class Hold { highest_opening, top, border, nothing };

struct SceneOptions {
    std::uint32_t particles = 0;        ///< about this many; 0: the scene's own number
    std::filesystem::path garment{};    ///< OBJ file, for scenes that take one
    std::filesystem::path motion{};     ///< BVH file or pipe, likewise
    double speed = 1;                   ///< of the motion, times its own
    bool skin = false;                  ///< what is worn meets the body's skin, not capsules
    Hold hold = Hold::highest_opening;  ///< of the scene garment
    bool y_is_up = false;               ///< in the garment's file; else +Z
};

/// A cloth of the scene with what drawing it needs.
struct SceneCloth {
    ClothId id;
    Mesh mesh;
    render::FabricLook look;
    Mesh fine{};                               ///< what is drawn in place of the mesh, where `drawn` is set
    std::shared_ptr<const DrawnMesh> drawn{};  ///< how it follows the cloth
};

/// What stands in the scene, of triangles.
struct SceneSolid {
    Mesh mesh;  ///< where it stands; vertices that triangles share are drawn smooth
    Vec3 colour;
    std::shared_ptr<const std::vector<Vec3>> moving{};  ///< where its vertices are, if they move
};

/// What build() leaves behind for the program that shows the scene.
struct SceneContent {
    std::vector<SceneCloth> cloths;
    std::vector<ColliderId> drawn_colliders;  ///< balls, capsules and boxes to draw; planes are the ground
    std::vector<SceneSolid> solids;
    render::OrbitCamera camera;
};

class Scene {
  public:
    virtual ~Scene() = default;

    /// Wind, substeps and gravity that the scene starts with; threads and executor are the program's.
    [[nodiscard]] virtual WorldSettings world_settings() const { return {}; }
    /// Adds cloths, pins and colliders to an empty world. Error: what could not be built, and why.
    [[nodiscard]] virtual Result<SceneContent> build(World& world, const SceneOptions& options) = 0;
    /// Moves pins and colliders before the step from `time` to `time + dt` [s].
    virtual void before_step(World& world, double time, float dt);
    /// Then: cuts cloth, in the content as well. True: it did.
    virtual bool cut_before_step(World& world, SceneContent& content);

    /// What is to be read and seen beside its cloths, as the world is now.
    virtual void annotate(const World& /*world*/, Annotation& /*to*/) const {}

    /// The scene's own test: after this many steps of 1/60 s ...
    [[nodiscard]] virtual int check_steps() const { return 300; }
    /// ... this must hold. Error: what does not, with its value.
    [[nodiscard]] virtual Result<void> check(const World& world) const = 0;
};

/// One line of the registry.
struct SceneEntry {
    const char* name;
    const char* description;
    std::unique_ptr<Scene> (*make)();
    bool needs_garment = false;          ///< cannot be built without SceneOptions::garment
    bool takes_garment = needs_garment;  ///< can be built with one
    bool takes_motion = false;           ///< likewise of SceneOptions::motion, speed and skin
};

/// All scenes, in the order in which they are listed. scenes/registry.cpp holds one line for each.
[[nodiscard]] std::span<const SceneEntry> all_scenes();
/// Null if there is none of that name.
[[nodiscard]] const SceneEntry* find_scene(std::string_view name);

}  // namespace weft::demo
