#include "demo/look/look.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "demo/hands/project.h"
#include "demo/options/method_table.h"

namespace weft::demo {

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

/// Draws words with a contrasting shadow, legible on any background.
void draw(const ShownWords& words, const render::OrbitCamera& camera) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const auto seen = project(camera, words.at, size.x / size.y);  // in picture heights
    if (!seen) return;
    const ImVec2 place(size.y * seen->x, size.y * seen->y);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const Vec3& colour = words.colour;
    const bool dark = colour.x + colour.y + colour.z < 1.5f;
    list.AddText({place.x + 1, place.y + 1}, dark ? IM_COL32(255, 255, 255, 140) : IM_COL32(0, 0, 0, 160),
                 words.words.c_str());
    list.AddText(place, ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, 1}),
                 words.words.c_str());
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

void draw_names(const Picture& picture, const Simulation& shown, const Comparison& comparison,
                const render::OrbitCamera& camera) {
    const ClothId first = shown.content().cloths.front().id;
    const auto cloth = shown.world().cloth(first);
    const auto settings = shown.world().cloth_settings(first);
    if (!cloth || !settings) return;
    const Bounds& box = cloth->bounds;
    const Vec3 over{0.5f * (box.lower.x + box.upper.x), box.upper.y + 0.15f,
                    0.5f * (box.lower.z + box.upper.z)};
    constexpr Vec3 white{1, 1, 1};
    draw({over, entry_of(settings->method).title, white}, camera);
    draw({{over.x + picture.beside(), over.y, over.z}, entry_of(comparison.method()).title, white}, camera);
}

void make_room_beside(render::OrbitCamera& camera, float beside, float& before) {
    if (beside == before) return;
    constexpr float part = 0.55f;  // share of the distance: the view had some room
    if (before > 0) {
        camera.target.x -= 0.5f * before;
        camera.distance = std::max(0.2f, camera.distance - part * before);  // the user may have zoomed in
    }
    camera.target.x += 0.5f * beside;
    camera.distance += part * beside;
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
