#pragma once
// A scene's solid as the renderer has it.

#include <vector>

#include "demo/scene.h"
#include "weft/render/scene_renderer.h"

namespace weft::demo {

class DrawnSolid {
  public:
    /// Shows the solid moved by `offset` [m]. The renderer draws it from the first update() on.
    DrawnSolid(const SceneSolid& solid, const Vec3& offset, render::SceneRenderer& renderer);
    /// Streams the solid's vertices, if it moves and the World has taken a step since.
    void update(const SceneSolid& solid, std::uint64_t step, render::SceneRenderer& renderer);
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

}  // namespace weft::demo
