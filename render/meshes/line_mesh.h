#pragma once
// Lines that change with every picture.

#include <span>

#include "render/gl/gl.h"
#include "weft/render/scene_renderer.h"

namespace weft::render {

class LineMesh {
  public:
    LineMesh();
    /// Precondition: the program made of lines.vert is in use. Leaves blending off.
    void draw(std::span<const DrawnLine> lines);

  private:
    struct Vertex {
        Vec3 point, color;
        float opacity;
    };
    VertexArray vertex_array_ = VertexArray::make();
    Buffer vertices_ = Buffer::make();
    std::vector<Vertex> streamed_;
};

}  // namespace weft::render
