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

/// A context that is current on the calling thread, with OpenGL's functions loaded. At most one per thread.
class Context {
  public:
    /// Error: no display, or no OpenGL 3.3 core.
    [[nodiscard]] static Result<Context> window(const WindowSettings& settings);
    /// An EGL context that needs no display and draws into framebuffer objects. It uses a graphics card where
    /// EGL offers one, else Mesa's software renderer. `checked`: as in WindowSettings. Error: says what EGL
    /// lacks.
    [[nodiscard]] static Result<Context> offscreen(bool checked = false);
    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;
    ~Context();

    [[nodiscard]] GLFWwindow* window_handle() const noexcept;  ///< null offscreen
    [[nodiscard]] std::string renderer() const;                ///< GL_RENDERER and GL_VERSION
    /// The driver's debug messages of severity medium or high since the last call, except those about
    /// performance. None where the context is not checked, or the driver lacks KHR_debug.
    [[nodiscard]] std::vector<std::string> take_complaints();

  private:
    struct Impl;
    explicit Context(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace weft::render
