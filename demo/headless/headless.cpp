#include "demo/headless/headless.h"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "demo/hands/hands.h"
#include "demo/headless/frame_table.h"
#include "demo/headless/report_text.h"
#include "demo/options/method_table.h"

namespace weft::demo {

namespace {

constexpr float frame_seconds = 1.0f / 60.0f;

/// Prints errors, and remembers whether there was one.
class Failures {
  public:
    void note(const Result<void>& result) {
        if (!result) note(result.error());
    }
    void note(const Error& error) {
        std::fprintf(stderr, "weft_demo: %s\n", error.message.c_str());
        any_ = true;
    }
    [[nodiscard]] bool any() const { return any_; }

  private:
    bool any_ = false;
};

std::filesystem::path picture_file(const Options& options, int frame) {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%06d.png", frame);
    return options.out / name;
}

/// Makes the output folder. Error: it cannot be made, or a file of the run cannot be written.
Result<void> prepare_files(const Options& options) {
    std::error_code cannot;
    std::filesystem::create_directories(options.out, cannot);
    if (cannot) {
        return Error{ErrorCode::file_not_found,
                     "--out " + options.out.string() + " cannot be used: " + cannot.message()};
    }
    for (const char* file : {"final.png", "frame_times.csv", "final.obj"}) {
        if (auto writable = check_writable("--out", options.out / file); !writable) return writable;
    }
    return check_writable("--trace", options.trace);  // it may lie in the same folder
}

/// Numbers of frames with each flag.
class Troubles {
  public:
    void add(const StepReport& report) {
        ++all_;
        for (std::size_t bit = 0; bit < frames_.size(); ++bit)
            if (has(seen_flags(report), flag(bit))) ++frames_[bit];
    }
    void print(float wind_speed) const {
        for (std::size_t bit = 0; bit < frames_.size(); ++bit) {
            // In single frames the best method leaves something unsolved, which nobody sees.
            const int most = flag(bit) == StepFlags::unsolved ? all_ / 5 : 0;
            if (frames_[bit] > most)
                std::printf("in %d frames: %s", frames_[bit], flags_text(flag(bit), wind_speed).c_str());
        }
    }

  private:
    static StepFlags flag(std::size_t bit) { return static_cast<StepFlags>(1u << bit); }
    std::array<int, 32> frames_{};
    int all_ = 0;
};

void print_summary(const Simulation& simulation, const FrameTable& table, const Troubles& troubles) {
    const StepReport& report = simulation.world().report();
    std::printf("scene %s, %u particles, %d substeps, %" PRIu64 " frames of 1/60 s\n",
                simulation.entry().name, report.particles, report.substeps, report.step);
    std::uint64_t bytes = 0;
    for (const SceneCloth& cloth : simulation.content().cloths)
        bytes += simulation.world().cloth_info(cloth.id).value().bytes;
    std::printf("cloths take %.1f MB, %.0f bytes a particle\n", 1e-6 * static_cast<double>(bytes),
                static_cast<double>(bytes) / std::max(1.0, static_cast<double>(report.particles)));
    std::fputs(table.summary().c_str(), stdout);
    troubles.print(speed_of(simulation.world().settings().wind));
    std::printf("hash: %016" PRIx64 "\n", simulation.world().state_hash());
}

void print_sides(const Simulation& simulation, const Comparison& comparison) {
    const auto print = [](const Method& method, const Comparison::Side& side) {
        std::printf("compared: %-20s %.2f ms a step, %.1f mm off, at most %.0f mm\n", entry_of(method).name,
                    static_cast<double>(side.milliseconds), static_cast<double>(side.usual),
                    static_cast<double>(side.farthest));
    };
    const ClothId first = simulation.content().cloths.front().id;
    print(simulation.world().cloth_settings(first)->method, comparison.shown());
    print(comparison.method(), comparison.other());
}

}  // namespace

int run_headless(const Options& options, Simulation& simulation) {
    if (auto prepared = prepare_files(options); !prepared) {
        std::fprintf(stderr, "weft_demo: %s\n", prepared.error().message.c_str());
        return 2;
    }
    Failures failures;
    std::optional<Photographer> photographer;
    if (auto made = Photographer::create(options, simulation)) {
        photographer.emplace(std::move(*made));
    } else {
        failures.note(Error{made.error().code, "no pictures: " + made.error().message});
    }

    for (const std::string& note : simulation.content().notes)
        std::fprintf(stderr, "weft_demo: note: %s\n", note.c_str());
    std::optional<Sequence> sequence;
    if (options.sequence) {
        auto begun = Sequence::begin(simulation, *options.sequence, options.out);
        if (!begun) {
            std::fprintf(stderr, "weft_demo: %s\n", begun.error().message.c_str());
            return 2;
        }
        sequence.emplace(std::move(*begun));
    }
    std::optional<Comparison> comparison;
    if (options.compare) {
        auto started = Comparison::start(simulation, *options.compare, Fairness::same_steps);
        if (!started) {
            std::fprintf(stderr, "weft_demo: --compare: %s\n", started.error().message.c_str());
            return 2;
        }
        comparison.emplace(std::move(*started));
    }
    const Comparison* const compared = comparison ? &*comparison : nullptr;
    if (!options.trace.empty()) failures.note(simulation.world().start_trace());
    const int frames = options.frames.value_or(Options::default_frames);
    FrameTable table;
    Troubles troubles;
    {
        Progress progress(simulation.entry().name, frames);
        for (int frame = 1; frame <= frames; ++frame) {
            troubles.add(simulation.step(frame_seconds));
            table.add(simulation.world().profile(), simulation.world().report());
            if (comparison) comparison->step(simulation, frame_seconds);
            if (sequence) failures.note(sequence->add(simulation));
            if (photographer) photographer->record(simulation);
            if (photographer && options.every > 0 && frame % options.every == 0)
                failures.note(photographer->shoot(simulation, picture_file(options, frame), compared));
            progress.update(frame);
        }
    }
    if (photographer) failures.note(photographer->shoot(simulation, options.out / "final.png", compared));

    if (photographer)
        for (const std::string& each : photographer->take_complaints())
            failures.note(Error{ErrorCode::unsupported, "OpenGL: " + each});
    if (sequence) failures.note(sequence->end());
    failures.note(table.write_csv(options.out / "frame_times.csv"));
    failures.note(
        save_obj(options.out / "final.obj", current_mesh(simulation.world(), simulation.content())));
    if (!options.trace.empty()) failures.note(simulation.world().write_trace(options.trace));
    if (!options.overrides.record.empty()) failures.note(simulation.world().stop_recording());
    print_summary(simulation, table, troubles);
    if (comparison) print_sides(simulation, *comparison);
    return failures.any() ? 1 : 0;
}

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
    if (options.panels || options.compare) {  // a comparison's names are drawn as panels are
        photographer.panels_.reset(new PanelsInPicture{render::ImGuiLayer(photographer.context_), Panels{}});
        photographer.panels_->panels.visible = options.panels;
    }
    return photographer;
}

void Photographer::record(const Simulation& simulation) {
    if (panels_) panels_->panels.record(simulation.world());
}

Result<void> Photographer::shoot(Simulation& simulation, const std::filesystem::path& file,
                                 const Comparison* comparison) {
    render::OrbitCamera camera = simulation.content().camera;
    camera.yaw += turn_;
    if (comparison != nullptr)
        picture_.set_beside(comparison->other_simulation(), comparison->truth(), simulation, camera.yaw);
    picture_.update(simulation);
    Vec3 before{};
    make_room_beside(camera, picture_.beside(), before);
    if (panels_) build_panels(simulation, camera, comparison);
    const render::View& view = picture_.view(simulation, camera, 1.0f);
    const auto overlay = [this] { panels_->layer.end(); };
    const render::Image image = panels_ ? picture_.renderer().capture(view, width_, height_, overlay)
                                        : picture_.renderer().capture(view, width_, height_);
    return render::save_png(image, file.c_str());
}

void Photographer::build_panels(Simulation& simulation, render::OrbitCamera& camera,
                                const Comparison* comparison) {
    WindControl wind(simulation.world().settings().wind.velocity);
    const Playback playback;
    Hands hands;
    panels_->layer.begin(width_, height_, 1.0f / 60.0f);
    (void)panels_->panels.draw(simulation, wind, hands, playback, camera);
    make_room_for_panels(camera, panels_->panels.covered(), static_cast<float>(width_),
                         static_cast<float>(height_));
    if (comparison != nullptr) draw_names(picture_, simulation, *comparison, camera);
}

}  // namespace weft::demo
