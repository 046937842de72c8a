#pragma once
// Meshes of solids, which solid.vert bends into shape, and lines.

#include <span>

#include "render/gl/gl.h"
#include "render/view/matrices.h"
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

/// One cube that solid.vert bends into every box.
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

/// Lines that change with every picture.
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
