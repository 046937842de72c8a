#pragma once
// Shows a Simulation through render's SceneRenderer.

#include <span>
#include <vector>

#include "demo/look/drawn_solid.h"
#include "demo/look/inside.h"
#include "demo/look/quality_choice.h"
#include "demo/look/rounded_mesh.h"
#include "demo/scene_simulation.h"
#include "weft/render/scene_renderer.h"

namespace weft::demo {

class Picture {
  public:
    /// Precondition: a render::Context is current, here and at every call.
    [[nodiscard]] static Result<Picture> create();

    /// Shows the cloths of a simulation that was just built, in place of those shown so far.
    void show(const Simulation& simulation);
    /// Streams the particles' present state, and uploads the meshes again after a cut.
    void update(const Simulation& simulation);
    /// The view to draw, with colliders that were thrown, and `lines` besides those of the inside. Valid
    /// until the next call.
    [[nodiscard]] const render::View& view(const Simulation& simulation, const render::OrbitCamera& camera,
                                           float alpha, std::span<const ColliderId> thrown = {},
                                           std::span<const render::DrawnLine> lines = {});

    bool shows_wind = true;  ///< draws the wind as an arrow on the ground

    /// Sets quality and views of the inside; the cloths' looks and triangles follow at the next update().
    void set_look(const QualityLevel& level, const Inside& inside);
    /// Shows another simulation of the `first` one's scene to its right, as a camera of that yaw [rad] sees
    /// it, and `truth` as a ghost in both places, from the next update() on. Both are as far from the camera.
    void set_beside(const Simulation& other, const Simulation& truth, const Simulation& first, float yaw);
    void set_alone();
    /// Displacement of the other [m]; 0 without one.
    [[nodiscard]] const Vec3& beside() const { return offset_; }
    /// The words of the inside, with their places.
    [[nodiscard]] std::span<const ShownWords> words() const { return drawing_.words; }

    [[nodiscard]] render::SceneRenderer& renderer() { return renderer_; }

  private:
    explicit Picture(render::SceneRenderer renderer);

    /// A finer mesh that is drawn in place of a cloth's own, by vertex.
    struct Fine {
        std::vector<Vec4> positions, previous_positions, normals, colours;
        RoundedMesh rounded;  ///< used where the scene has no finer mesh itself
    };
    void add_collider(const World& world, ColliderId id, ColliderMotion& motion);
    void show_cloth(const SceneCloth& cloth, const World& world);
    void add_colliders_beside();
    void update_rounded(const ClothView& view, std::size_t index, bool lies_on_itself);
    void update_fine(const SceneCloth& cloth, const ClothView& view, std::size_t index);

    render::SceneRenderer renderer_;
    std::uint32_t cuts_ = 0;                   // number of cuts that are shown
    std::vector<render::ClothHandle> cloths_;  // in the order of SceneContent::cloths
    ColliderMotion motion_, motion_beside_;
    std::vector<DrawnSolid> solids_;  // in the order of SceneContent::solids
    std::vector<Fine> fine_;          // as cloths_; empty where the cloth's own mesh is drawn
    Inside inside_;
    const Simulation* other_ = nullptr;
    const Simulation* truth_ = nullptr;
    float room_beside_ = 0;  // [m]
    Vec3 offset_;
    Beside beside_, ghost_{true}, ghost_beside_{true};
    InsideDrawing drawing_;
    std::vector<Vec4> colours_;  // colours of a cloth's particles
    render::Quality quality_;
    /// True if meshes are rounded. Two compared simulations are drawn as they are.
    [[nodiscard]] bool rounds() const { return rounded_ && other_ == nullptr; }
    /// True if a cloth's finer mesh is drawn: a map is painted on what is simulated.
    [[nodiscard]] bool draws_fine(const SceneCloth& cloth) const { return cloth.drawn && !shown_painted_; }
    bool rounded_ = true, shown_rounded_ = true, shown_painted_ = false;
    std::vector<render::DrawnSphere> spheres_;
    std::vector<render::DrawnCapsule> capsules_;
    std::vector<render::DrawnTaperedCapsule> tapered_capsules_;
    std::vector<render::DrawnBox> boxes_;
    std::vector<render::DrawnLine> lines_;
    render::View view_;
};

}  // namespace weft::demo
