#pragma once
// Lines and words over a picture.

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
};

}  // namespace weft::demo
