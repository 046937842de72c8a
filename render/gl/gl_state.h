#pragma once
// The host's OpenGL state. Each constructor saves a part of it and sets that part to OpenGL's defaults; the
// destructor restores it. So the host's state changes no picture, and no picture changes it.

#include <glad/gl.h>

#include <array>

namespace weft::render {

/// Framebuffers and the viewport. They are saved but not reset, since every draw sets them.
class SavedTarget {
  public:
    SavedTarget();
    SavedTarget(const SavedTarget&) = delete;
    SavedTarget& operator=(const SavedTarget&) = delete;
    ~SavedTarget();

  private:
    GLint draw_ = 0, read_ = 0;
    std::array<GLint, 4> viewport_{};
};

/// State that creating, filling and reading objects depends on: the layout of pixels in memory, and bound
/// objects. Only the layout and the pixel buffers are reset; the other bindings are saved alone.
class SavedBindings {
  public:
    SavedBindings();
    SavedBindings(const SavedBindings&) = delete;
    SavedBindings& operator=(const SavedBindings&) = delete;
    ~SavedBindings();

  private:
    std::array<GLint, 16> pixel_store_{};
    GLint array_buffer_ = 0, uniform_buffer_ = 0, pack_buffer_ = 0, unpack_buffer_ = 0;
    GLint renderbuffer_ = 0, vertex_array_ = 0, program_ = 0;
    GLint active_unit_ = 0, texture_ = 0;
};

/// Textures and samplers of the units that the shaders read, and the uniform block that they share.
class SavedUnits {
  public:
    SavedUnits();
    SavedUnits(const SavedUnits&) = delete;
    SavedUnits& operator=(const SavedUnits&) = delete;
    ~SavedUnits();

  private:
    static constexpr std::size_t units = 9;
    std::array<GLint, units> textures_{}, samplers_{};
    GLint block_buffer_ = 0;
    GLint64 block_start_ = 0, block_size_ = 0;
};

/// Rasterisation, tests of fragments, masks and blending.
class SavedRaster {
  public:
    SavedRaster();
    SavedRaster(const SavedRaster&) = delete;
    SavedRaster& operator=(const SavedRaster&) = delete;
    ~SavedRaster();

  private:
    std::array<GLboolean, 28> capabilities_{};
    GLboolean blend_ = GL_FALSE, depth_mask_ = GL_TRUE;
    std::array<GLboolean, 4> color_mask_{};
    std::array<GLint, 6> blending_{};  // source and destination of colour, of alpha; equation of each
    GLint depth_func_ = 0, cull_face_ = 0, front_face_ = 0, derivative_hint_ = 0, provoking_vertex_ = 0;
    std::array<GLint, 2> polygon_mode_{};
    std::array<GLdouble, 2> depth_range_{};
    GLdouble clear_depth_ = 1;
    GLfloat line_width_ = 1, offset_factor_ = 0, offset_units_ = 0;
};

/// All state that drawing a picture depends on, except its target.
struct SavedDrawing {
    SavedBindings bindings;
    SavedUnits units;
    SavedRaster raster;
};

}  // namespace weft::render
