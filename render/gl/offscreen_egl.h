#pragma once
// OpenGL without a display: EGL contexts that have no surface.

#include "weft/error.h"

namespace weft::render {

/// A current OpenGL 3.3 core context without surface; not current and destroyed with this object.
class OffscreenEgl {
  public:
    /// `checked`: one that the driver looks after, where it can. Error: what each EGL platform answered.
    [[nodiscard]] static Result<OffscreenEgl> create(bool checked);
    OffscreenEgl(OffscreenEgl&& other) noexcept;
    OffscreenEgl& operator=(OffscreenEgl&& other) noexcept;
    ~OffscreenEgl();

    using Function = void (*)();
    [[nodiscard]] static Function function(const char* name);

  private:
    OffscreenEgl(void* display, void* context) : display_(display), context_(context) {}
    void* display_;  // EGLDisplay
    void* context_;  // EGLContext; null when moved from
};

}  // namespace weft::render
