#pragma once
// Dear ImGui on a Context's window, or on an offscreen framebuffer of a given size.

#include <memory>

#include "weft/render/context.h"

namespace weft::render {

/// A layer with its own Dear ImGui context. That context is current between begin() and end(), where the host
/// calls ImGui:: freely. All other calls leave the host's context current. At most one layer exists.
class ImGuiLayer {
  public:
    /// Precondition: the Context outlives the layer. A host with GLFW callbacks of its own sets them before;
    /// the layer passes events on to them.
    explicit ImGuiLayer(Context& context);
    ImGuiLayer(ImGuiLayer&&) noexcept;
    ImGuiLayer& operator=(ImGuiLayer&&) noexcept;
    ~ImGuiLayer();

    /// Starts a frame. The size [pixels] and the time [s] are used offscreen only; a window has its own.
    void begin(int width, int height, float seconds_since_last);
    /// Draws the frame's widgets into the bound framebuffer. OpenGL's state is left as it was.
    void end();

    [[nodiscard]] bool wants_mouse() const;  ///< the pointer is over a panel
    [[nodiscard]] bool wants_keyboard() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace weft::render
