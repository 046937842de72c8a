#pragma once
// One mesh that solid.vert bends into every sphere and capsule.

#include "render/gl/gl.h"
#include "render/view/light_frame.h"
#include "weft/render/scene_renderer.h"

namespace weft::render {

/// A unit sphere, cut at its equator: each vertex belongs to one end of the capsule. A sphere is a capsule
/// whose ends coincide.
class CapsuleMesh {
  public:
    CapsuleMesh();
    /// Precondition: a program made of solid.vert is in use.
    void draw(const Program& program, const DrawnTaperedCapsule& capsule) const;

  private:
    VertexArray vertex_array_;
    Buffer vertices_, indices_;
    GLsizei index_count_ = 0;
};

[[nodiscard]] DrawnTaperedCapsule as_tapered(const DrawnSphere& sphere);
[[nodiscard]] DrawnTaperedCapsule as_tapered(const DrawnCapsule& capsule);
[[nodiscard]] Box bounds_of(const DrawnTaperedCapsule& capsule);

}  // namespace weft::render
