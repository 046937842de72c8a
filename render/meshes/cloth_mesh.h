#pragma once
// A cloth on the graphics card: its triangles, and its particles as the simulation keeps them.

#include "render/gl/gl.h"
#include "render/view/matrices.h"
#include "weft/render/scene_renderer.h"

namespace weft::render {

/// A per-particle buffer that shaders read by particle index: particle i is texel (i mod width, i div width).
/// The texture is two-dimensional, since a buffer texture need not hold more than 65 536 elements, while 1024
/// x 1024 texels are within what OpenGL 3.3 guarantees.
class ParticleTexture {
  public:
    static constexpr GLsizei width = 1024;

    ParticleTexture();
    void upload(std::span<const Vec4> particles);
    void bind(int texture_unit) const;

  private:
    Texture texture_;
    GLsizei height_ = 0;
};

class ClothMesh {
  public:
    explicit ClothMesh(const ClothSurface& surface);

    void stream(const ClothFrame& frame);
    /// Precondition: a program made of cloth.vert is in use.
    void draw(const Program& program, float alpha) const;
    /// Draws each part in its colours. Precondition: the program that shades cloth is in use, with the look's
    /// uniforms.
    void draw_shaded(const Program& program, float alpha) const;

    [[nodiscard]] const Box& bounds() const noexcept { return bounds_; }  ///< box round both position buffers

    FabricLook look;

  private:
    struct Vertex {
        Vec2 texcoord;
        std::uint32_t particle;
    };
    /// Triangles of one part, side by side in the index buffer.
    struct Part {
        GLsizei first = 0, count = 0;  // indices
        Vec3 front, back;
        std::size_t picture = 0;  // in pictures_, from 1; 0: none
    };
    [[nodiscard]] static std::vector<Vertex> vertices_of(const ClothSurface& surface);
    /// The triangles, those of one part after the other.
    [[nodiscard]] std::vector<std::array<std::uint32_t, 3>> take_parts(const ClothSurface& surface);
    [[nodiscard]] bool bind(const Program& program, float alpha) const;

    VertexArray vertex_array_;
    Buffer vertices_, indices_;
    GLsizei index_count_ = 0;
    bool textured_ = false;
    std::vector<Part> parts_;  // empty: all triangles have the look's colours
    std::vector<Texture> pictures_;
    ParticleTexture positions_, previous_positions_, normals_, colours_;
    bool coloured_ = false;
    Box bounds_;
};

}  // namespace weft::render
