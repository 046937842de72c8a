#pragma once
// Another simulation of the same scene, drawn beside the first.

#include <vector>

#include "demo/look/drawn_solid.h"
#include "demo/scene_simulation.h"
#include "weft/render/scene_renderer.h"

namespace weft::demo {

class Beside {
  public:
    /// Shows `other`, or nothing if it is null. Adds and removes drawn cloths as needed.
    void show(const Simulation* other, const Simulation& first, render::SceneRenderer& renderer);
    /// Displacement of the other from its own place [m].
    [[nodiscard]] const Vec3& offset() const { return offset_; }
    [[nodiscard]] bool shown() const { return !cloths_.empty(); }

  private:
    void begin(const Simulation& other, const Simulation& first, render::SceneRenderer& renderer);
    [[nodiscard]] std::span<const Vec4> moved(std::span<const Vec4> positions, std::vector<Vec4>& to) const;

    std::vector<render::ClothHandle> cloths_;
    std::vector<DrawnSolid> solids_;
    Vec3 offset_;
    std::vector<Vec4> positions_, previous_, colours_;
};

}  // namespace weft::demo
