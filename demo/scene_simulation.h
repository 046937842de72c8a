#pragma once
// A scene in a World, with what the command line changes about it.

#include <cstdint>
#include <memory>
#include <optional>

#include "demo/cutting/cut_scene.h"
#include "demo/rung.h"
#include "demo/scene.h"

namespace weft::demo {

/// What a run asks for in place of the scene's own settings.
struct Overrides {
    std::optional<Vec3> wind;  ///< [m/s]
    std::optional<Method> method;
    std::optional<Fabric> fabric;
    std::optional<int> iterations;  ///< of the method, whichever it is
    std::optional<int> substeps;
    std::optional<Rung> contact;
    int threads = 0;               ///< 0: one per core
    std::filesystem::path record;  ///< where the World's calls are written down; empty: nowhere
};

class Simulation {
  public:
    /// Error: a world or scene that cannot be built, and why.
    [[nodiscard]] static Result<Simulation> create(const SceneEntry& entry, const SceneOptions& options,
                                                   const Overrides& overrides);

    /// Sets what a run asks for; threads and recording are create()'s alone. Error: a cloth refuses it.
    [[nodiscard]] Result<void> apply(const Overrides& overrides);

    /// Moves the scene's pins and colliders, then the world, by dt [s].
    const StepReport& step(float dt) {
        before_step(dt);
        return world_.step(dt);
    }
    /// The scene's part of it alone: the World's own step has to follow.
    void before_step(float dt);
    /// The World was put back to where it was at that time [s].
    void set_time(double seconds) { time_ = seconds; }

    /// The scene from its start, with the settings that the world and the cloths have now. Error: it cannot
    /// be built any more, and why; what runs goes on as it was. A recording ends with the World that it is
    /// of.
    [[nodiscard]] Result<void> restart();
    /// The settings that the world and the cloths started with; what moves goes on.
    [[nodiscard]] Result<void> restore_defaults();
    /// Gives all cloths a fabric's threads, shine and light; their colours stay.
    void weave(const render::FabricLook& look);

    [[nodiscard]] const SceneEntry& entry() const { return *entry_; }
    [[nodiscard]] Scene& scene() { return *scene_; }
    [[nodiscard]] const Scene& scene() const { return *scene_; }
    /// What the scene is built by: of the next restart().
    [[nodiscard]] SceneOptions& options() { return options_; }
    [[nodiscard]] World& world() { return world_; }
    [[nodiscard]] const World& world() const { return world_; }
    [[nodiscard]] const SceneContent& content() const { return content_; }
    /// Parts edges of a cloth of the content, if they are more than the inside of a cut.
    Result<void> cut(std::size_t cloth, std::span<const MeshEdge> edges);
    /// How often cloth was cut: with each, a mesh of the content is another.
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
