#pragma once
// Dear ImGui on a Context's window, or on an offscreen framebuffer of a given size.

#include <memory>

#include "weft/render/context.h"

namespace weft::render {

/// Has a Dear ImGui context of its own, which is the current one between begin() and end(), where the host
/// calls ImGui:: as it likes. Whichever was current before is so again after every other call. One at a time.
class ImGuiLayer {
  public:
    /// Precondition: the Context outlives the layer. A host that has GLFW callbacks of its own sets them
    /// before; they go on being called.
    explicit ImGuiLayer(Context& context);
    ImGuiLayer(ImGuiLayer&&) noexcept;
    ImGuiLayer& operator=(ImGuiLayer&&) noexcept;
    ~ImGuiLayer();

    /// Starts a frame. Width and height in pixels are used offscreen only; a window knows its own.
    void begin(int width, int height, float seconds_since_last);
    /// Draws what was built into the framebuffer that is bound. OpenGL's state is left as it was.
    void end();

    [[nodiscard]] bool wants_mouse() const;  ///< the pointer is over a panel
    [[nodiscard]] bool wants_keyboard() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace weft::render
