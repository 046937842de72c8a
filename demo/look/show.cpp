#include "demo/look/show.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <chrono>
#include <utility>

#include "demo/hands/project.h"

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

}  // namespace

void begin_look(Picture& picture, Look& look) {
    constexpr int first_by_processor = 4;
    look.by_processor = picture.renderer().drawn_by_processor();
    if (look.by_processor) look.quality.start_at(first_by_processor);
}

void draw_picture(Picture& picture, const render::View& view, int width, int height, Look& look) {
    const Clock::time_point start = Clock::now();
    picture.renderer().draw(view, width, height);
    // A processor is waited for, since it can do nothing else meanwhile; a graphics card says later.
    if (look.by_processor) picture.renderer().wait();
    const float took =
        look.by_processor ? milliseconds_since(start) : picture.renderer().draw_times().total();
    look.quality.add(took);
    look.times.add_picture(took, 1000 * ImGui::GetIO().DeltaTime);
}

void draw_words(const Picture& picture, const render::OrbitCamera& camera) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    for (const ShownWords& each : picture.words()) {
        const auto seen = project(camera, each.at, size.x / size.y);  // in heights
        if (!seen) continue;
        const ImVec2 place(size.y * seen->x, size.y * seen->y);
        draw.AddText({place.x + 1, place.y + 1}, IM_COL32(0, 0, 0, 160), each.words.c_str());
        draw.AddText(place, ImGui::ColorConvertFloat4ToU32({each.colour.x, each.colour.y, each.colour.z, 1}),
                     each.words.c_str());
    }
}

std::string save_pictures(Picture& picture, const render::View& view, int width, int height, Look& look) {
    std::string words;
    if (std::exchange(look.wants_film, false)) words = begin_or_end_film(look.recorder);
    const bool one = std::exchange(look.wants_picture, false);
    if (!one && !look.recorder.recording()) return words;
    render::View best = view;
    best.quality = {};
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
