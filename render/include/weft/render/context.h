#pragma once
// An OpenGL 3.3 core context: a window where there is a display, or none at all.

#include <memory>
#include <string>
#include <vector>

#include "weft/error.h"

struct GLFWwindow;

namespace weft::render {

struct WindowSettings {
    int width = 1280, height = 800;
    std::string title = "Weft";
    bool vsync = true;
    bool checked = false;  ///< the driver checks every call: Context::take_complaints()
};

/// A current context on the calling thread, functions loaded. One at a time per thread.
class Context {
  public:
    /// Error: no display, or no OpenGL 3.3 core.
    [[nodiscard]] static Result<Context> window(const WindowSettings& settings);
    /// Without display or GPU: EGL on Mesa's surfaceless platform, rendering into framebuffer objects.
    /// Error: says what EGL lacks.
    /// `checked`: as in WindowSettings.
    [[nodiscard]] static Result<Context> offscreen(bool checked = false);
    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;
    ~Context();

    [[nodiscard]] GLFWwindow* window_handle() const noexcept;  ///< null offscreen
    [[nodiscard]] std::string renderer() const;                ///< GL_RENDERER and GL_VERSION
    /// What the driver has objected to since the last call, with severity medium or high: calls that are
    /// errors, and what it need not bear or is slow at. None where the context is not checked, or the driver
    /// lacks KHR_debug.
    [[nodiscard]] std::vector<std::string> take_complaints();

  private:
    struct Impl;
    explicit Context(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace weft::render
