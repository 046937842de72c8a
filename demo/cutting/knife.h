#pragma once
// A knife that is drawn over the picture: it cuts the cloth under the pointer, all layers of it.

#include <vector>

#include "demo/scene_simulation.h"
#include "weft/cutting.h"
#include "weft/render/camera.h"

namespace weft::demo {

class Knife {
  public:
    /// It is put down where the ray points.
    void begin(const Simulation& simulation, const render::Ray& ray);
    /// It is drawn on to where that ray points, and cuts along the way. Error: cloth that cannot be cut, and
    /// why; the rest is.
    Result<void> draw_to(const render::Ray& ray, Simulation& simulation);

  private:
    render::Ray last_{};
    std::vector<CutStroke> strokes_;  // of each cloth of the scene
};

}  // namespace weft::demo
