#pragma once
// Lines and words over a picture, and solids that are only drawn.

#include <string>
#include <vector>

#include "weft/render/scene_renderer.h"

namespace weft::demo {

struct ShownWords {
    Vec3 at;  ///< [m]
    std::string words;
    Vec3 colour;
};

struct Annotation {
    std::vector<render::DrawnLine> lines;
    std::vector<ShownWords> words;
    std::vector<render::DrawnSphere> spheres;
    std::vector<render::DrawnCapsule> capsules;
};

}  // namespace weft::demo
