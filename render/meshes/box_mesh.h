#pragma once
// One cube that solid.vert bends into every box.

#include "render/gl/gl.h"
#include "render/view/light_frame.h"
#include "weft/render/scene_renderer.h"

namespace weft::render {

class BoxMesh {
  public:
    BoxMesh();
    /// Precondition: a program made of solid.vert is in use.
    void draw(const Program& program, const DrawnBox& box) const;

  private:
    VertexArray vertex_array_;
    Buffer vertices_;
};

[[nodiscard]] Box bounds_of(const DrawnBox& box);

}  // namespace weft::render
