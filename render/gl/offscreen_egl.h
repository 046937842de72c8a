#pragma once
// OpenGL without a display: EGL contexts that have no surface.

#include "weft/error.h"

namespace weft::render {

/// A current OpenGL 3.3 core context without a surface; the destructor releases and destroys it.
class OffscreenEgl {
  public:
    /// `checked`: a debug context, where EGL can make one (1.5). Error: what each EGL platform answered.
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
