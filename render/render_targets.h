#pragma once
// The framebuffers that a picture passes through.

#include "render/gl.h"
#include "weft/render/scene_renderer.h"

namespace weft::render {

/// Depth seen from a light; read both compared (for filtered shadows) and plain (for the distance of what
/// casts them).
class DepthMap {
  public:
    explicit DepthMap(int texels);

    void begin() const;  ///< binds, sets the viewport and clears
    void bind(int plain_unit) const;
    void bind(int plain_unit, int compare_unit) const;
    [[nodiscard]] int texels() const noexcept { return texels_; }

  private:
    int texels_;
    Texture texture_;
    Framebuffer framebuffer_;
    Sampler compare_;
};

/// The multisampled picture in display-linear light, half floats, so that its resolve averages light and not
/// codes.
class ScenePicture {
  public:
    /// Keeps what it has where the size is the same.
    void resize(int width, int height);
    void begin() const;  ///< binds, sets the viewport and clears the depth
    void resolve(
        int texture_unit) const;  ///< averages the samples into a texture, and binds that to a texture unit

  private:
    int width_ = 0, height_ = 0;
    Renderbuffer color_, depth_;
    Framebuffer samples_;
    Texture resolved_color_;
    Framebuffer resolved_;
};

/// An 8-bit RGB framebuffer that is read back.
class CaptureTarget {
  public:
    void resize(int width, int height);
    [[nodiscard]] GLuint framebuffer() const noexcept { return framebuffer_.id(); }
    [[nodiscard]] Image read() const;

  private:
    int width_ = 0, height_ = 0;
    Texture color_;
    Framebuffer framebuffer_;
};

}  // namespace weft::render
