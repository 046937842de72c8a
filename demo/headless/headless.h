#pragma once
// A run without a window: a fixed number of steps, then pictures, tables and a hash.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "demo/headless/picture.h"
#include "demo/options/options.h"
#include "demo/panels/panels.h"
#include "demo/scene_simulation.h"
#include "weft/render/context.h"
#include "weft/render/imgui_layer.h"

namespace weft::demo {

/// Leaves in Options::out: final.png (or pictures of every n-th frame), frame_times.csv, final.obj; prints
/// the stages' percentiles and the state hash. Returns the program's exit status: 2 for a folder that cannot
/// be used, 1 where something could not be drawn or written; the rest is done all the same.
[[nodiscard]] int run_headless(const Options& options, Simulation& simulation);

/// Takes pictures of a Simulation without a window.
class Photographer {
  public:
    /// Draws offscreen, or with the context of a window where that fails. Error: what both lack.
    [[nodiscard]] static Result<Photographer> create(const Options& options, const Simulation& simulation);

    /// The driver's debug messages since the last call, with Options::check_gl.
    [[nodiscard]] std::vector<std::string> take_complaints() { return context_.take_complaints(); }

    /// Records the step that was just taken, for the panels.
    void record(const Simulation& simulation);
    /// Writes a PNG of the simulation as it is now, and of what it is compared with; null: nothing.
    [[nodiscard]] Result<void> shoot(Simulation& simulation, const std::filesystem::path& file,
                                     const Comparison* comparison);

  private:
    struct PanelsInPicture {
        render::ImGuiLayer layer;
        Panels panels;
    };

    Photographer(render::Context context, Picture picture, int width, int height);
    /// The camera makes room for them.
    void build_panels(Simulation& simulation, render::OrbitCamera& camera, const Comparison* comparison);

    // Destroyed from the last to the first: OpenGL's objects before its context.
    render::Context context_;
    Picture picture_;
    std::unique_ptr<PanelsInPicture> panels_;  // null: neither panels nor words are drawn
    int width_, height_;
    float turn_ = 0;  // angle of the camera from the scene's own [rad]
};

}  // namespace weft::demo
