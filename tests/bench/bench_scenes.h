#pragma once
// The measured scenes: cloths that have moved long enough to hang in folds, or to lie on something.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "cloth/simulation/simulation.h"

namespace weft::bench {

/// All have air of the default density, that drags; the garment's sizes are those that its file has.
enum class SceneKind {
    hanging,       ///< a sheet of 1 m, by two corners
    hanging_self,  ///< the same with self-collision at 0.8 of the spacing
    draped,        ///< the sheet on a sphere of radius 0.3 m that lies on the ground, with friction and
                   ///< self-collision
    garment,       ///< tshirt-iso.obj by its highest particles, over a capsule, with self-collision
    dress,         ///< dress-victor-iso-draped.obj, likewise
};
[[nodiscard]] const char* name_of(SceneKind kind);
/// True if WEFT_DATA leads to the garment's file.
[[nodiscard]] bool has_garment(SceneKind kind = SceneKind::garment);

class Scene {
  public:
    /// Warmed up: 0.75 s after the start.
    Scene(SceneKind kind, std::uint32_t side, int threads, const ClothSettings& settings, bool air = true);
    /// as_mesh: a sheet that does not say that it is a grid.
    Scene(SceneKind kind, std::uint32_t side, const WorldSettings& world, const ClothSettings& settings,
          bool as_mesh = false);

    void frame() { simulation_->step(1.0f / 60.0f); }
    [[nodiscard]] Simulation& simulation() { return *simulation_; }
    [[nodiscard]] Cloth& cloth() { return *cloth_; }
    [[nodiscard]] std::uint32_t particles() const { return cloth_->model.particle_count; }
    /// The equation of the next step, from the present state.
    [[nodiscard]] StepEquation equation() const;

  private:
    std::unique_ptr<Simulation> simulation_;
    Cloth* cloth_ = nullptr;  // the simulation's
};

/// The scene of that name, made when it is first asked for; only the last one is kept.
[[nodiscard]] Scene& cached_scene(const std::string& name, const std::function<Scene()>& make);

}  // namespace weft::bench
