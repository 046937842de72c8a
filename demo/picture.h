#pragma once
// Shows a Simulation through render's SceneRenderer.

#include <span>
#include <vector>

#include "demo/scene_simulation.h"
#include "weft/render/scene_renderer.h"

namespace weft::demo {

class Picture {
  public:
    /// Precondition: a render::Context is current, here and at every call.
    [[nodiscard]] static Result<Picture> create();

    /// Takes over the cloths of a simulation that was just built, in place of those shown so far.
    void show(const Simulation& simulation);
    /// Streams the particles as they are now.
    void update(const Simulation& simulation);
    /// What to draw, with what was thrown into the scene. Valid until the next call.
    [[nodiscard]] const render::View& view(const Simulation& simulation, const render::OrbitCamera& camera,
                                           float alpha, std::span<const ColliderId> thrown = {});

    bool shows_wind = true;  ///< as an arrow on the ground

    [[nodiscard]] render::SceneRenderer& renderer() { return renderer_; }

  private:
    explicit Picture(render::SceneRenderer renderer);

    /// What of a cloth is drawn over it, by vertex.
    struct Fine {
        std::vector<Vec4> positions, previous_positions, normals;
    };
    void add_collider(const World& world, ColliderId id);
    void show_solid(const SceneSolid& solid);
    void update_solid(const SceneSolid& solid, render::ClothHandle drawn);
    void update_fine(const SceneCloth& cloth, const ClothView& view, std::size_t index);

    render::SceneRenderer renderer_;
    std::vector<render::ClothHandle> cloths_;  // in the order of SceneContent::cloths
    std::vector<render::ClothHandle> solids_;
    std::vector<Fine> fine_;  // likewise; empty where the cloth itself is drawn
    std::vector<render::DrawnSphere> spheres_;
    std::vector<render::DrawnCapsule> capsules_;
    std::vector<render::DrawnTaperedCapsule> tapered_capsules_;
    std::vector<render::DrawnBox> boxes_;
    render::View view_;
};

}  // namespace weft::demo
