#include "demo/headless/photographer.h"

#include <numbers>
#include <utility>

#include "demo/hands/hands.h"

namespace weft::demo {
namespace {

Result<render::Context> any_context(const Options& options) {
    auto offscreen = render::Context::offscreen(options.check_gl);
    if (offscreen) return offscreen;
    auto window = render::Context::window({.width = options.width,
                                           .height = options.height,
                                           .title = "Weft",
                                           .vsync = false,
                                           .checked = options.check_gl});
    if (window) return window;
    return Error{offscreen.error().code, "cannot draw offscreen (" + offscreen.error().message +
                                             ") nor in a window (" + window.error().message + ")"};
}

}  // namespace

Photographer::Photographer(render::Context context, Picture picture, int width, int height)
    : context_(std::move(context)), picture_(std::move(picture)), width_(width), height_(height) {}

Result<Photographer> Photographer::create(const Options& options, const Simulation& simulation) {
    auto context = any_context(options);
    if (!context) return context.error();
    auto picture = Picture::create();
    if (!picture) return picture.error();
    Photographer photographer(std::move(*context), std::move(*picture), options.width, options.height);
    photographer.turn_ = static_cast<float>(options.turn) * std::numbers::pi_v<float> / 180;
    photographer.picture_.show(simulation);
    if (options.panels) {
        photographer.panels_.reset(new PanelsInPicture{render::ImGuiLayer(photographer.context_), Panels{}});
    }
    return photographer;
}

void Photographer::record(const Simulation& simulation) {
    if (panels_) panels_->panels.record(simulation.world());
}

Result<void> Photographer::shoot(Simulation& simulation, const std::filesystem::path& file) {
    picture_.update(simulation);
    render::OrbitCamera camera = simulation.content().camera;
    camera.yaw += turn_;
    if (panels_) build_panels(simulation);
    const render::View& view = picture_.view(simulation, camera, 1.0f);
    const auto overlay = [this] { panels_->layer.end(); };
    const render::Image image = panels_ ? picture_.renderer().capture(view, width_, height_, overlay)
                                        : picture_.renderer().capture(view, width_, height_);
    return render::save_png(image, file.c_str());
}

void Photographer::build_panels(Simulation& simulation) {
    WindControl wind(simulation.world().settings().wind.velocity);
    const Playback playback;
    Hands hands;
    panels_->layer.begin(width_, height_, 1.0f / 60.0f);
    (void)panels_->panels.draw(simulation, wind, hands, playback, simulation.content().camera);
}

}  // namespace weft::demo
