#pragma once
// The framebuffers that a picture passes through.

#include "render/gl/gl.h"
#include "weft/render/scene_renderer.h"

namespace weft::render {

/// A depth map seen from a light, sampled with comparison (for filtered shadows) and without (for the
/// distance of blockers).
class DepthMap {
  public:
    explicit DepthMap(int texels);
    void resize(int texels);  ///< keeps the content if the size is the same

    void begin() const;  ///< binds, sets the viewport and clears
    void bind(int plain_unit) const;
    void bind(int plain_unit, int compare_unit) const;
    [[nodiscard]] int texels() const noexcept { return texels_; }

  private:
    int texels_ = 0;
    Texture texture_;
    Framebuffer framebuffer_;
    Sampler compare_;
};

/// The picture in linear display light, as half floats. Averages of samples, and of pixels where the picture
/// is enlarged, are therefore averages of light and not of sRGB codes.
class ScenePicture {
  public:
    /// Keeps the content if the size is the same.
    void resize(int width, int height, int samples);
    void begin() const;  ///< binds, sets the viewport and clears the depth
    /// Averages the samples into a texture and binds it to a texture unit. `smooth`: linear filtering, for a
    /// picture that is shown in another size.
    void resolve(int texture_unit, bool smooth) const;

  private:
    int width_ = 0, height_ = 0, samples_ = 0;
    Renderbuffer color_, depth_;
    Framebuffer drawn_;  // multisampled; a single sample is drawn into resolved_
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
