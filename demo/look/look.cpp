#include "demo/look/look.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "demo/hands/project.h"
#include "demo/options/method_table.h"

namespace weft::demo {

namespace {

std::filesystem::path numbered(const std::filesystem::path& folder, const char* form, int number) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), form, number);
    return folder / name.data();
}

/// The first unused name of weft-0001, weft-0002, and so on.
std::filesystem::path free_name(const std::filesystem::path& folder, const char* form) {
    std::error_code ignored;
    int number = 1;
    while (std::filesystem::exists(numbered(folder, form, number), ignored)) ++number;
    return numbered(folder, form, number);
}

/// Runs a program and discards its output. True if it exited with 0.
bool run(std::vector<std::string> arguments) {
    std::vector<char*> argv;
    for (std::string& each : arguments) argv.push_back(each.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t nowhere;
    posix_spawn_file_actions_init(&nowhere);
    for (const int stream : {0, 1, 2})
        posix_spawn_file_actions_addopen(&nowhere, stream, "/dev/null", stream == 0 ? 0 : 1, 0);
    pid_t child = 0;
    const int failed = posix_spawnp(&child, argv[0], &nowhere, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&nowhere);
    int status = 0;
    return failed == 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) &&
           WEXITSTATUS(status) == 0;
}

}  // namespace

bool program_is_there(const std::string& name) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((std::filesystem::path(folder) / name).c_str(), X_OK) == 0) return true;
    return false;
}

Result<std::filesystem::path> Recorder::save(const render::Image& image) {
    const std::filesystem::path file = free_name(folder_, "weft-%04d.png");
    if (auto saved = render::save_png(image, file.c_str()); !saved) return saved.error();
    return file;
}

Result<void> Recorder::start() {
    const std::filesystem::path film = free_name(folder_, "weft-film-%04d");
    std::error_code cannot;
    std::filesystem::create_directories(film, cannot);
    if (cannot)
        return Error{ErrorCode::file_not_found, film.string() + " cannot be made: " + cannot.message()};
    film_ = film;
    pictures_ = 0;
    return {};
}

Result<void> Recorder::add(const render::Image& image) {
    if (!recording()) return {};
    return render::save_png(image, numbered(film_, "picture_%06d.png", ++pictures_).c_str());
}

Result<std::string> Recorder::stop() {
    const std::filesystem::path film = std::exchange(film_, {});
    if (film.empty()) return std::string();
    const std::string pictures =
        std::to_string(pictures_) + " pictures in " + film.string() + " (30 a second)";
    if (!program_is_there("ffmpeg")) return pictures + "; with ffmpeg installed they become a film, too";
    const std::string file = film.string() + ".mp4";
    const bool made = run({"ffmpeg", "-y", "-framerate", "30", "-i", (film / "picture_%06d.png").string(),
                           "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", file});
    if (!made) return Error{ErrorCode::file_not_found, "ffmpeg made no film of the " + pictures};
    return file + ", of " + pictures;
}

namespace {

using Clock = std::chrono::steady_clock;

float milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<float, std::milli>(Clock::now() - start).count();
}

std::string told(const Result<std::filesystem::path>& saved) {
    return saved ? "saved " + saved->string() : saved.error().message;
}

std::string begin_or_end_film(Recorder& recorder) {
    if (!recorder.recording()) {
        const auto started = recorder.start();
        return started ? std::string() : started.error().message;
    }
    const auto stopped = recorder.stop();
    return stopped ? "recorded " + *stopped : stopped.error().message;
}

/// Draws words with a contrasting shadow, legible on any background. `above`: they end at their place, with
/// their middle over it; otherwise they begin there.
void draw(const ShownWords& words, const render::OrbitCamera& camera, bool above = false) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const auto seen = project(camera, words.at, size.x / size.y);  // in picture heights
    if (!seen) return;
    ImVec2 place(size.y * seen->x, size.y * seen->y);
    if (above) {
        const ImVec2 extent = ImGui::CalcTextSize(words.words.c_str());
        place = {std::max(place.x - 0.5f * extent.x, 0.0f), std::max(place.y - extent.y, 0.0f)};
    }
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const Vec3& colour = words.colour;
    const bool dark = colour.x + colour.y + colour.z < 1.5f;
    list.AddText({place.x + 1, place.y + 1}, dark ? IM_COL32(255, 255, 255, 140) : IM_COL32(0, 0, 0, 160),
                 words.words.c_str());
    list.AddText(place, ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, 1}),
                 words.words.c_str());
}

/// Draws what a compared cloth is computed by, and its cost and error, in three lines.
void draw_side(Vec3 at, const char* method, const Comparison::Side& side, const render::OrbitCamera& camera) {
    constexpr Vec3 white{1, 1, 1};
    char words[160];
    std::snprintf(words, sizeof words, "%s, %d substep%s\n%.2f ms a step\n%.1f mm off, at most %.0f mm",
                  method, side.substeps, side.substeps == 1 ? "" : "s",
                  static_cast<double>(side.milliseconds), static_cast<double>(side.usual),
                  static_cast<double>(side.farthest));
    draw({at, words, white}, camera, true);
}

}  // namespace

void begin_look(Picture& picture, Look& look) {
    constexpr int first_by_processor = 4;
    look.by_processor = picture.renderer().drawn_by_processor();
    if (look.by_processor) look.quality.start_at(first_by_processor);
}

void draw_picture(Picture& picture, const render::View& view, int width, int height, Look& look) {
    const Clock::time_point start = Clock::now();
    picture.renderer().draw(view, width, height);
    // A drawing processor is waited for, since it can do nothing else; a graphics card reports later.
    if (look.by_processor) picture.renderer().wait();
    const float took =
        look.by_processor ? milliseconds_since(start) : picture.renderer().draw_times().total();
    look.quality.add(took, width * height);
    look.times.add_picture(took, 1000 * ImGui::GetIO().DeltaTime);
}

void draw_words(const Picture& picture, const render::OrbitCamera& camera) {
    for (const ShownWords& each : picture.words()) draw(each, camera);
}

std::string recording_words(const Recorder& recorder) {
    if (!recorder.recording()) return {};
    char words[64];
    const float seconds = static_cast<float>(recorder.pictures()) / Recorder::pictures_a_second;
    std::snprintf(words, sizeof words, "recording: %.1f s, F6 ends it", static_cast<double>(seconds));
    return words;
}

void draw_recording(const Recorder& recorder, float room) {
    const std::string words = recording_words(recorder);
    if (words.empty()) return;
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    const float em = ImGui::GetFontSize();
    const ImVec2 place(room - size.x - 1.5f * em, 0.9f * em);  // messages stand to the left
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled({place.x - 2 * em, place.y - 0.4f * em}, {place.x + size.x + em, place.y + 1.4f * em},
                       IM_COL32(10, 12, 16, 190), 0.3f * em);
    list.AddCircleFilled({place.x - em, place.y + 0.5f * em}, 0.4f * em, IM_COL32(235, 50, 45, 255));
    list.AddText(place, IM_COL32(255, 255, 255, 255), words.c_str());
}

void draw_names(const Picture& picture, const Simulation& shown, const Comparison& comparison,
                const render::OrbitCamera& camera) {
    const ClothId first = shown.content().cloths.front().id;
    const auto cloth = shown.world().cloth(first);
    const auto settings = shown.world().cloth_settings(first);
    if (!cloth || !settings) return;
    const Bounds& box = cloth->bounds;
    float top = box.upper.y;  // of who wears the cloth, too
    for (const ColliderId id : shown.content().clad_colliders) {
        const auto limb = shown.world().collider(id);
        const auto* const capsule = limb ? std::get_if<TaperedCapsule>(&limb->shape) : nullptr;
        if (capsule != nullptr)
            top = std::max({top, capsule->a.y + capsule->radius_a, capsule->b.y + capsule->radius_b});
    }
    const Vec3 over{0.5f * (box.lower.x + box.upper.x), top + 0.1f, 0.5f * (box.lower.z + box.upper.z)};
    const Vec3& beside = picture.beside();
    draw_side({over.x, over.y, over.z}, entry_of(settings->method).title, comparison.shown(), camera);
    draw_side({over.x + beside.x, over.y, over.z + beside.z}, entry_of(comparison.method()).title,
              comparison.other(), camera);
}

void make_room_for_panels(render::OrbitCamera& camera, float covered, float width, float height) {
    if (width <= 0 || height <= 0) return;
    constexpr float wide_enough = 1.15f;
    camera.shift = covered / width;
    camera.shrink = std::min(1.0f, (width - covered) / height / wide_enough);
}

void make_room_beside(render::OrbitCamera& camera, const Vec3& beside, Vec3& before) {
    constexpr float part = 0.75f;  // share of the distance: the view had some room
    const float now = std::hypot(beside.x, beside.z), then = std::hypot(before.x, before.z);
    camera.target.x += 0.5f * (beside.x - before.x);
    camera.target.z += 0.5f * (beside.z - before.z);
    if (std::abs(now - then) > 1e-3f) camera.distance = std::max(0.2f, camera.distance + part * (now - then));
    before = beside;
}

std::string save_pictures(Picture& picture, const render::View& view, int width, int height, Look& look) {
    std::string words;
    if (std::exchange(look.wants_film, false)) words = begin_or_end_film(look.recorder);
    const bool one = std::exchange(look.wants_picture, false);
    if (!one && !look.recorder.recording()) return words;
    render::View best = view;
    best.quality = {};
    best.camera.shift = 0;  // no panels cover the saved picture
    best.camera.shrink = 1;
    const render::Image image = picture.renderer().capture(best, width, height);
    if (one) words = told(look.recorder.save(image));
    if (const auto added = look.recorder.add(image); !added) words = added.error().message;
    return words;
}

bool read_look_keys(const KeyTaps& keys, Look& look) {
    look.wants_picture |= keys.count(GLFW_KEY_F5) > 0;
    look.wants_film |= keys.count(GLFW_KEY_F6) % 2 == 1;
    return keys.count(GLFW_KEY_F2) % 2 == 1;
}

}  // namespace weft::demo
