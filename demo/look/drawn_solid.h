#pragma once
// Solids and colliders as they are drawn, at and between two steps; and a second simulation beside the first.

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "demo/scene.h"
#include "demo/scene_simulation.h"
#include "weft/render/scene_renderer.h"
#include "weft/world.h"

namespace weft::demo {

/// A scene's solid as the renderer has it.
class DrawnSolid {
  public:
    /// The renderer draws the solid from the first update() on.
    DrawnSolid(const SceneSolid& solid, render::SceneRenderer& renderer);
    /// Streams the solid's vertices, displaced by `offset` [m], if the offset is another, or it moves and the
    /// World has taken a step since.
    void update(const SceneSolid& solid, std::uint64_t step, render::SceneRenderer& renderer,
                const Vec3& offset = {});
    void remove(render::SceneRenderer& renderer) { renderer.remove_cloth(handle_); }

  private:
    [[nodiscard]] std::vector<Vec4> placed(const SceneSolid& solid, SolidMoment moment);

    render::ClothHandle handle_ = 0;  // null: the solid has no vertices
    Vec3 offset_;
    bool is_drawn_ = false;
    std::uint64_t step_ = 0;  // after which it is drawn
    Mesh mesh_;
    std::vector<Vec4> positions_;
};

/// Colliders are drawn between two steps, as late as the cloth that lies on them: their places there.
class ColliderMotion {
  public:
    /// Keeps the collider's place after the World's last step, if it is a new one. Call this for each
    /// picture.
    void note(ColliderId id, const Collider& collider, std::uint64_t step);
    /// The collider at that share of the way from the step before to the last, 0 to 1. One that has jumped is
    /// where it is. Precondition: note() was called for it.
    [[nodiscard]] Collider at(ColliderId id, float share) const;
    void forget() { motions_.clear(); }

  private:
    struct Motion {
        Collider before, now;
        std::uint64_t step;
    };
    using Key = std::pair<std::uint32_t, std::uint32_t>;
    [[nodiscard]] static Key key(ColliderId id) { return {id.index, id.generation}; }
    std::map<Key, Motion> motions_;
};

/// Another simulation of the same scene, drawn displaced.
class Beside {
  public:
    /// A ghost is translucent, casts no shadow and has no solids.
    explicit Beside(bool is_ghost = false) : is_ghost_(is_ghost) {}
    /// Shows `other` displaced by `offset` [m], or nothing if it is null. Adds and removes drawn cloths as
    /// needed.
    void show(const Simulation* other, const Vec3& offset, render::SceneRenderer& renderer);

  private:
    void begin(const Simulation& other, render::SceneRenderer& renderer);
    [[nodiscard]] std::span<const Vec4> moved(std::span<const Vec4> positions, std::vector<Vec4>& to) const;

    std::vector<render::ClothHandle> cloths_;
    std::vector<DrawnSolid> solids_;
    bool is_ghost_;
    Vec3 offset_;
    std::vector<Vec4> positions_, previous_, colours_;
};

/// Distance at which a second simulation of the scene is clear of the first, whatever the camera's side [m].
[[nodiscard]] float room_beside(const Simulation& simulation);

}  // namespace weft::demo
