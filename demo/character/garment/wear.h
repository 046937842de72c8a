#pragma once
// Measures whether a garment is worn well: none of it is inside the body, and it is not stretched.

#include <vector>

#include "demo/character/body/body.h"
#include "weft/mesh.h"
#include "weft/world.h"

namespace weft::demo {

/// Measures a garment on a body, step after step. Triangles all of whose corners are pinned are left out.
class WearMeter {
  public:
    /// `kept`: the distance that the cloth keeps from colliders [m].
    WearMeter(const Mesh& mesh, float kept);

    struct Wear {
        float deepest = 0;           ///< greatest penetration depth [m]; 0: none is inside
        std::uint32_t inside = 0;    ///< triangles deeper than `kept` that no squeeze excuses
        float deepest_of_these = 0;  ///< greatest penetration depth of `inside` [m]
        std::uint32_t squeezed = 0;  ///< triangles between two parts of the body that leave them no room
        float stretch_99 = 1, stretch = 1;  ///< length over rest length of edges: 99th percentile, worst
    };
    /// Call this once after each step. A squeeze excuses a triangle while it lasts and for five steps more.
    [[nodiscard]] Wear measure(const ClothView& cloth, const std::vector<TaperedCapsule>& body);

  private:
    struct Edge {
        std::uint32_t a, b;  // vertices
        float rest;          // [m]
    };
    Mesh mesh_;
    float kept_;
    std::vector<Edge> edges_;
    std::vector<int> squeezed_at_;  // last squeezed step, by triangle
    std::vector<float> ratios_;
    int step_ = 0;
};

}  // namespace weft::demo
