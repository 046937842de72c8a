#pragma once
// A scene in a World, with the command line's changes.

#include <cstdint>
#include <memory>
#include <optional>

#include "demo/cutting/cut_scene.h"
#include "demo/scene.h"
#include "demo/self_collision.h"

namespace weft::demo {

/// Settings of a run, in place of the scene's own.
struct Overrides {
    std::optional<Vec3> wind{};  ///< [m/s]
    std::optional<Method> method{};
    std::optional<Fabric> fabric{};
    std::optional<int> iterations{};  ///< of the method, whichever it is
    std::optional<int> substeps{};
    std::optional<SelfCollisionMethod> contact{};
    int threads = 0;                 ///< 0: one per core
    std::filesystem::path record{};  ///< file for a recording of the World's calls; empty: none
};

class Simulation {
  public:
    /// Error: a world or scene that cannot be built, and why.
    [[nodiscard]] static Result<Simulation> create(const SceneEntry& entry, const SceneOptions& options,
                                                   const Overrides& overrides);

    /// Applies the overrides; threads and recording are create()'s alone. Error: a cloth refuses one.
    [[nodiscard]] Result<void> apply(const Overrides& overrides);

    /// Moves the scene's pins and colliders, then the world, by dt [s].
    const StepReport& step(float dt) {
        before_step(dt);
        return world_.step(dt);
    }
    /// The scene's part of step() alone: World::step() has to follow.
    void before_step(float dt);
    /// Call this when the World was restored to its state at that time [s].
    void set_time(double seconds) {
        time_ = seconds;
        scene_->go_to(seconds);
    }

    /// Restarts the scene with the present settings of the world and the cloths. Error: why it cannot be
    /// built any more; the running scene is unchanged. A recording ends with its World.
    [[nodiscard]] Result<void> restart();
    /// Restores the first settings of the world and the cloths; the motion continues.
    [[nodiscard]] Result<void> restore_defaults();
    /// Gives all cloths a fabric's threads, shine and light; their colours stay.
    void weave(const render::FabricLook& look);

    [[nodiscard]] const SceneEntry& entry() const { return *entry_; }
    [[nodiscard]] Scene& scene() { return *scene_; }
    [[nodiscard]] const Scene& scene() const { return *scene_; }
    /// Options by which the scene is built; changes take effect at the next restart().
    [[nodiscard]] SceneOptions& options() { return options_; }
    [[nodiscard]] const SceneOptions& options() const { return options_; }
    [[nodiscard]] World& world() { return world_; }
    [[nodiscard]] const World& world() const { return world_; }
    [[nodiscard]] const SceneContent& content() const { return content_; }
    /// Splits edges of a cloth of the content, unless that would add no particle.
    Result<void> cut(std::size_t cloth, std::span<const MeshEdge> edges);
    /// Sets a map of a cloth of the content, one value a vertex. A restart keeps it. Error: the World's; a
    /// leash where nobody wears the cloth.
    Result<void> paint(std::size_t cloth, Map map, std::vector<float> values);
    /// Number of cuts and restarts; each replaces meshes of the content.
    [[nodiscard]] std::uint32_t cuts() const { return cuts_; }
    [[nodiscard]] double time() const { return time_; }  ///< [s]

  private:
    void remember_defaults();
    Simulation(const SceneEntry& entry, const SceneOptions& options, std::unique_ptr<Scene> scene,
               World world);
    Result<void> build();

    const SceneEntry* entry_;
    SceneOptions options_;
    std::unique_ptr<Scene> scene_;
    World world_;
    SceneContent content_;
    WorldSettings first_settings_;
    std::vector<ClothSettings> first_cloths_;  // in the order of content_.cloths
    double time_ = 0;
    std::uint32_t cuts_ = 0;
};

/// All cloths of a scene as one mesh, as they are drawn now.
[[nodiscard]] Mesh current_mesh(const World& world, const SceneContent& content);

}  // namespace weft::demo
