#pragma once
// The frame of a light's depth map: the box, seen from the light, that holds everything that casts a shadow.

#include <Eigen/Geometry>

#include "render/view/matrices.h"

namespace weft::render {

using Box = Eigen::AlignedBox3f;

struct LightFrame {
    Matrix4f clip_from_world;
    float side;   ///< of the square map [m]
    float depth;  ///< from its near to its far plane [m]
};

/// Fits a map of `texels` on a side round the casters; `direction`: unit, towards the parallel light. The map
/// moves by whole texels and grows by steps of a quarter, so that shadows do not crawl.
[[nodiscard]] LightFrame fit_light(const Vector3& direction, const Box& casters, int texels);

}  // namespace weft::render
