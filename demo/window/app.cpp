#include "demo/window/app.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "demo/hands/hands.h"
#include "demo/hands/overlay.h"
#include "demo/headless/picture.h"
#include "demo/look/look.h"
#include "demo/look/settings_file.h"
#include "demo/panels/panels.h"
#include "demo/time/time_bar.h"
#include "demo/time/timeline.h"
#include "demo/window/camera_drift.h"
#include "demo/window/input.h"
#include "demo/window/wind_control.h"
#include "weft/render/context.h"
#include "weft/render/imgui_layer.h"

namespace weft::demo {
namespace {

struct PictureSize {
    int width = 0, height = 0;
    [[nodiscard]] float aspect() const { return static_cast<float>(width) / static_cast<float>(height); }
    [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
};

PictureSize framebuffer_size(GLFWwindow* window) {
    PictureSize size;
    glfwGetFramebufferSize(window, &size.width, &size.height);
    return size;
}

Pointer read_pointer(const render::ImGuiLayer& layer) {
    const ImGuiIO& io = ImGui::GetIO();
    return {.x = io.MousePos.x / io.DisplaySize.x,
            .y = io.MousePos.y / io.DisplaySize.y,
            .right = io.MouseDelta.x / io.DisplaySize.y,
            .down = io.MouseDelta.y / io.DisplaySize.y,
            .left_button = io.MouseDown[ImGuiMouseButton_Left],
            .other_button = io.MouseDown[ImGuiMouseButton_Right] || io.MouseDown[ImGuiMouseButton_Middle],
            .wheel = io.MouseWheel,
            .over_panel = layer.wants_mouse(),
            .has_knife = io.KeyShift};
}

class App {
  public:
    App(const Options& options, Simulation simulation, render::Context context, Picture picture)
        : options_(options),
          simulation_(std::move(simulation)),
          context_(std::move(context)),
          picture_(std::move(picture)),
          layer_(heard(context_)),
          last_(glfwGetTime()) {
        picture_.shows_wind = false;  // the hands draw an arrow of their own
        arrive();
        if (!options_.compare) return;
        panels_.look.compared = *options_.compare;
        panels_.look.wants_comparison = true;
    }

    [[nodiscard]] int run(const AppLook& look) {
        if (!options_.trace.empty()) {
            if (const auto started = simulation_.world().start_trace(); !started) complain(started.error());
        }
        GLFWwindow* const window = context_.window_handle();
        remember_dropped_files(window);
        begin_look(picture_, panels_.look);
        for (int frame = 0; glfwWindowShouldClose(window) == 0; ++frame) {
            if (options_.frames && frame == *options_.frames) break;
            glfwPollEvents();
            draw_frame(framebuffer_size(window));
            glfwSwapBuffers(window);
            print_objections();
            if (look && !look({frame, simulation_, wind_, hands_, timeline_, playback_, camera_, panels_}))
                break;
        }
        const int written = write_trace();
        return objected_ ? 1 : written;
    }

  private:
    /// Registers keys_ before the layer, which passes events on to them.
    render::Context& heard(render::Context& context) {
        keys_.listen_to(context.window_handle());
        return context;
    }

    void draw_frame(PictureSize size) {
        const double now = glfwGetTime();
        const double seconds = now - std::exchange(last_, now);
        for (const auto& file : take_dropped_files()) take_file(file);
        layer_.begin(size.width, size.height, static_cast<float>(seconds));
        make_room_for_panels(camera_, panels_.covered(), ImGui::GetIO().DisplaySize.x,
                             ImGui::GetIO().DisplaySize.y);
        if (!size.empty()) use_hands(size.aspect(), static_cast<float>(seconds));
        if (!size.empty()) drift(size.aspect(), static_cast<float>(seconds));
        if (!layer_.wants_keyboard()) read_keys(static_cast<float>(seconds));
        keys_.forget();
        advance(seconds);

        Look& look = panels_.look;
        picture_.set_look(look.quality.now(), look.inside);
        if (look.comparison)
            picture_.set_beside(look.comparison->other_simulation(), look.comparison->truth(), simulation_,
                                camera_.yaw);
        else
            picture_.set_alone();
        picture_.update(simulation_);
        make_room_beside(camera_, picture_.beside(), beside_);
        const render::View& view = picture_.view(
            simulation_, camera_, alpha_, hands_.balls.in_play(simulation_.world()), hands_.streaks.lines());
        draw_picture(picture_, view, size.width, size.height, look);
        if (!size.empty()) tell(save_pictures(picture_, view, size.width, size.height, look));
        draw_panels();
    }

    void draw_panels() {
        draw_words(picture_, camera_);
        draw_recording(panels_.look.recorder, ImGui::GetIO().DisplaySize.x - panels_.covered());
        if (panels_.look.comparison) draw_names(picture_, simulation_, *panels_.look.comparison, camera_);
        draw_overlay(hands_, simulation_, camera_, wind_, has(panels_.look.inside.parts, DebugParts::pins));
        const PanelRequests requests = panels_.draw(simulation_, wind_, hands_, playback_, camera_);
        TimeRequests time;
        if (panels_.visible)
            time = time_bar(timeline_, playback_, repeat_, ImGui::GetIO().DisplaySize.x - panels_.covered());
        layer_.end();
        if (time.go_to) go_to(*time.go_to);
        if (requests.restart || requests.reload || time.restart) restart();
        if (time.defaults) change_scene(simulation_.entry());
        if (std::exchange(panels_.look.ends_comparison, false)) end_comparison();
        if (std::exchange(panels_.look.wants_comparison, false)) compare();
        keep_settings();
        if (requests.scene == nullptr) return;
        options_.scene_options = simulation_.options();
        change_scene(*requests.scene);
    }

    /// Keeps the cloth in the picture, and lets the camera go round while nobody does anything.
    void drift(float aspect, float seconds) {
        const ImGuiIO& io = ImGui::GetIO();
        const bool moved = io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0;
        const bool quiet = playback_.paused || panels_.look.comparison || panels_.look.recorder.recording();
        if (moved || ImGui::IsAnyMouseDown() || !keys_.empty() || quiet) drift_.wake();
        drift_.update(bounds_of_cloth(simulation_), aspect, seconds, camera_);
    }

    /// Applies the mouse and the gamepad.
    void use_hands(float aspect, float seconds) {
        const Pointer pointer = read_pointer(layer_);
        pointed_ = camera_.ray(pointer.x, pointer.y, aspect);
        const Vec3 before = wind_.velocity();
        hands_.update(pointer, aspect, simulation_, camera_, wind_);
        if (std::string complaint = hands_.take_complaint(); !complaint.empty())
            panels_.message = std::move(complaint);
        const Gamepad pad = read_gamepad();
        steer_by(pad, camera_.yaw, seconds, wind_);
        if (pad.throws && !pad_.throws) note(hands_.throw_ball(simulation_, camera_.ray(0.5f, 0.5f, aspect)));
        if (pad.blasts && !pad_.blasts) hands_.blast(simulation_, camera_, camera_.ray(0.5f, 0.5f, aspect));
        pad_ = pad;
        const Vec3 after = wind_.velocity();
        if (after.x != before.x || after.z != before.z) apply_wind();
    }

    /// Takes the whole steps that fit into the real time.
    void advance(double seconds) {
        if (panels_.look.recorder.recording())
            seconds = 1.0 / static_cast<double>(Recorder::pictures_a_second);
        // A comparison takes several times as long. It goes on more slowly, so that every step is seen.
        if (panels_.look.comparison) seconds = std::min(seconds, clock_.settings().step);
        const FixedStepFrame frame =
            clock_.advance(playback_.paused ? 0 : seconds * static_cast<double>(playback_.speed));
        playback_.behind_real_time = frame.dropped_seconds > 0;
        for (int i = 0; i < frame.steps; ++i) step();
        alpha_ = frame.alpha;
        for (; playback_.single_steps > 0; --playback_.single_steps) step();
    }

    void step() {
        const auto dt = static_cast<float>(clock_.settings().step);
        hands_.before_step(simulation_, dt);
        simulation_.before_step(dt);
        repeat_.step(simulation_.world(), cloths_, dt);
        hands_.after_step(simulation_, dt);
        panels_.record(simulation_.world());
        if (panels_.look.comparison) {
            panels_.look.comparison->step(simulation_, dt);
            panels_.look.times.add_step(panels_.look.comparison->milliseconds());
        }
        note(timeline_.keep(simulation_, hands_.mark()));
    }

    /// Restores a moment of the timeline.
    void go_to(std::size_t which) {
        if (which >= timeline_.size()) return;
        end_comparison();  // what is compared has no past to go to
        const HandMark mark = timeline_.mark_of(which);
        note(hands_.prepare(simulation_, mark));
        if (auto gone = timeline_.go_to(which, simulation_); !gone) return complain(gone.error());
        hands_.arrive_in(simulation_, mark);
        clock_.reset();
        alpha_ = 1;
    }

    /// 1 while the key is down, else 0.
    [[nodiscard]] float held(int key) {
        return glfwGetKey(context_.window_handle(), key) == GLFW_PRESS ? 1.0f : 0.0f;
    }

    void read_keys(float seconds) {
        const float turn = held(GLFW_KEY_LEFT) - held(GLFW_KEY_RIGHT);
        const float faster = held(GLFW_KEY_UP) - held(GLFW_KEY_DOWN);
        if (turn != 0 || faster != 0) steer_wind(turn, faster, seconds);
        if (keys_.count(GLFW_KEY_SPACE) % 2 == 1) playback_.paused = !playback_.paused;
        if (keys_.count(GLFW_KEY_F1) % 2 == 1) panels_.help = !panels_.help;
        if (keys_.count(GLFW_KEY_G) % 2 == 1) panels_.gallery = !panels_.gallery;
        if (read_look_keys(keys_, panels_.look)) panels_.visible = !panels_.visible;
        if (keys_.count(GLFW_KEY_R) > 0) restart();
        if (const int steps = keys_.count(GLFW_KEY_N, true); steps > 0) {
            playback_.paused = true;
            playback_.single_steps += steps;
        }
        for (int k = keys_.count(GLFW_KEY_COMMA, true); k > 0; --k) step_back();
        for (int k = keys_.count(GLFW_KEY_PERIOD, true); k > 0; --k) step_on();
        read_keys_of_hands();
        const std::span<const SceneEntry> scenes = all_scenes();
        for (std::size_t k = 0; k < std::min<std::size_t>(scenes.size(), 9); ++k)
            if (keys_.count(GLFW_KEY_1 + static_cast<int>(k)) > 0) return change_scene(scenes[k]);
    }

    void step_back() {
        playback_.paused = true;
        if (timeline_.here() > 0) go_to(timeline_.here() - 1);
    }
    void step_on() {
        playback_.paused = true;
        if (timeline_.here() + 1 < timeline_.size())
            go_to(timeline_.here() + 1);
        else
            ++playback_.single_steps;
    }

    void read_keys_of_hands() {
        if (keys_.count(GLFW_KEY_P) % 2 == 1) note(hands_.pin_or_unpin(simulation_, pointed_));
        for (int k = keys_.count(GLFW_KEY_T); k > 0; --k) note(hands_.throw_ball(simulation_, pointed_));
        if (keys_.count(GLFW_KEY_B) > 0) hands_.blast(simulation_, camera_, pointed_);
        if (held(GLFW_KEY_F) > 0)
            hands_.blow(simulation_, camera_, pointed_);
        else
            hands_.air.put_fan_away();
    }

    void steer_wind(float turn, float faster, float seconds) {
        wind_.steer(turn, faster, seconds);
        apply_wind();
    }

    void apply_wind() {
        WorldSettings settings = simulation_.world().settings();
        settings.wind.velocity = wind_.velocity();
        (void)simulation_.world().set_settings(settings);  // a WindControl's wind is always in range
    }

    void restart() {
        end_comparison();
        if (auto restarted = simulation_.restart(); !restarted) return complain(restarted.error());
        begin_anew();
    }

    void change_scene(const SceneEntry& entry) {
        Overrides overrides;
        overrides.threads = simulation_.world().settings().threads;
        auto next = Simulation::create(entry, options_.scene_options, overrides);
        if (!next) return complain(next.error());
        simulation_ = std::move(*next);
        arrive();
    }

    /// Resets all that belonged to the previous world.
    void begin_anew() {
        picture_.set_alone();
        picture_.show(simulation_);
        cloths_.clear();
        for (const SceneCloth& cloth : simulation_.content().cloths) cloths_.push_back(cloth.id);
        hands_.begin(simulation_);
        panels_.forget();
        repeat_.forget();
        timeline_.clear();
        note(timeline_.keep(simulation_));
        clock_.reset();
    }

    void arrive() {
        begin_anew();
        camera_ = simulation_.content().camera;
        beside_ = {};
        wind_ = WindControl(simulation_.world().settings().wind.velocity);
        for (const std::string& note : simulation_.content().notes) panels_.message += note + "\n";
    }

    void take_file(const std::filesystem::path& file) {
        const FileKind kind = kind_of(file);
        if (kind == FileKind::settings) return take_settings(file);
        if (kind == FileKind::unknown)
            return complain({ErrorCode::invalid_argument, file.string() + " is no OBJ, glTF or JSON file"});
        options_.scene_options.garment = file;
        panels_.own_file = true;
        change_scene(*find_scene(kind == FileKind::garment ? "garment" : "character"));
    }

    void take_settings(const std::filesystem::path& file) {
        if (auto loaded = load_settings(file, simulation_); !loaded) return complain(loaded.error());
        wind_ = WindControl(simulation_.world().settings().wind.velocity);
        panels_.message = "loaded " + file.string();
    }

    void end_comparison() {
        if (panels_.look.comparison) panels_.look.comparison->end(simulation_);
        panels_.look.comparison.reset();
    }

    void compare() {
        restart();
        auto started = Comparison::start(simulation_, panels_.look.compared, panels_.look.fairness);
        if (!started) return complain(started.error());
        panels_.look.comparison.emplace(std::move(*started));
    }

    void keep_settings() {
        Look& look = panels_.look;
        if (std::exchange(look.wants_load, false)) take_settings(look.settings_file);
        if (!std::exchange(look.wants_save, false)) return;
        const auto saved = save_settings(look.settings_file, simulation_);
        panels_.message = saved ? "saved " + look.settings_file : saved.error().message;
    }

    void note(const Result<void>& done) {
        if (!done) complain(done.error());
    }
    void complain(const Error& error) { panels_.message = error.message; }
    void tell(const std::string& words) {
        if (!words.empty()) panels_.message = words;
    }

    void print_objections() {
        for (const std::string& each : context_.take_complaints()) {
            std::fprintf(stderr, "weft_demo: OpenGL: %s\n", each.c_str());
            objected_ = true;
        }
    }

    [[nodiscard]] int write_trace() const {
        if (options_.trace.empty()) return 0;
        const auto written = simulation_.world().write_trace(options_.trace);
        if (!written) std::fprintf(stderr, "weft_demo: %s\n", written.error().message.c_str());
        return written ? 0 : 1;
    }

    Options options_;
    Simulation simulation_;
    // Destroyed from the last to the first: OpenGL's objects before its context.
    render::Context context_;
    Picture picture_;
    KeyTaps keys_;
    render::ImGuiLayer layer_;

    FixedStep clock_;
    double last_;            // time of the last picture [s]
    float alpha_ = 1;        // blend between the last two steps
    Vec3 beside_;            // displacement of the second scene that the camera makes room for [m]
    bool objected_ = false;  // the driver reported a problem
    Hands hands_;
    Gamepad pad_;
    render::Ray pointed_{};  // the ray through the pointer
    std::vector<ClothId> cloths_;
    Timeline timeline_;
    RepeatCheck repeat_;
    Panels panels_;
    Playback playback_;
    WindControl wind_;
    render::OrbitCamera camera_;
    CameraDrift drift_;
};

}  // namespace

int run_app(const Options& options, Simulation simulation, const AppLook& look) {
    if (auto writable = check_writable("--trace", options.trace); !writable) {
        std::fprintf(stderr, "weft_demo: %s\n", writable.error().message.c_str());
        return 2;
    }
    const auto fail = [](const Error& error) {
        std::fprintf(stderr, "weft_demo: %s; --headless needs no display\n", error.message.c_str());
        return 1;
    };
    auto context = render::Context::window(
        {.width = options.width, .height = options.height, .checked = options.check_gl});
    if (!context) return fail(context.error());
    auto picture = Picture::create();
    if (!picture) return fail(picture.error());
    return App(options, std::move(simulation), std::move(*context), std::move(*picture)).run(look);
}

}  // namespace weft::demo
