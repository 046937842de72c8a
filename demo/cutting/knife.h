#pragma once
// A knife that is drawn over the picture: it cuts the cloth under the pointer, all layers of it.

#include <vector>

#include "demo/scene_simulation.h"
#include "weft/cutting.h"
#include "weft/render/camera.h"

namespace weft::demo {

class Knife {
  public:
    /// Begins a stroke at the ray.
    void begin(const Simulation& simulation, const render::Ray& ray);
    /// Continues the stroke to that ray and cuts between. Error: why a cloth cannot be cut; others are.
    Result<void> draw_to(const render::Ray& ray, Simulation& simulation);

  private:
    render::Ray last_{};
    std::vector<CutStroke> strokes_;  // one for each cloth of the scene
};

}  // namespace weft::demo
