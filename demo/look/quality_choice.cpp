#include "demo/look/quality_choice.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "demo/headless/frame_table.h"

namespace weft::demo {

void PictureTimes::add_picture(float drawing, float whole) {
    present_.drawing = drawing;
    present_.whole = whole;
    times_[next_] = present_;
    present_ = {};
    next_ = (next_ + 1) % length;
    size_ = std::min(size_ + 1, length);
}

PictureTime PictureTimes::percentile(float p) const {
    if (size_ == 0) return {};
    const auto of = [&](float PictureTime::*part) {
        std::vector<float> sample;
        for (std::size_t age = 0; age < size_; ++age) sample.push_back(at(age).*part);
        return demo::percentile(std::move(sample), static_cast<double>(p));
    };
    return {of(&PictureTime::cloth), of(&PictureTime::drawing), of(&PictureTime::whole)};
}

const char* what_is_slow(const PictureTime& usual, bool drawing_chosen) {
    if (usual.cloth >= usual.drawing && usual.cloth >= usual.rest())
        return "Slower than real time: the cloth takes most of a picture's time. Fewer substeps, less "
               "self-collision or a budget make it faster.";
    if (usual.drawing >= usual.rest())
        return drawing_chosen
                   ? "Slower than real time: drawing takes most of a picture's time, with all switched off "
                     "that can be. A smaller window helps."
                   : "Slower than real time: drawing takes most of a picture's time. Choose a faster "
                     "quality, or let it be chosen.";
    return "Slower than real time: neither cloth nor drawing takes the time, but the window system or other "
           "programs.";
}

namespace {

constexpr render::Quality fast{
    .samples = 1, .sun_map = 512, .blocker_taps = 0, .sun_taps = 4, .sky_taps = 0, .weave = false};

constexpr render::Quality of_resolution(render::Quality quality, float resolution) {
    quality.resolution = resolution;
    return quality;
}

// Costs were measured by llvmpipe at 1280 x 800, the flag: 200 ms at the best level.
constexpr QualityLevel ladder[] = {
    {"best", {}, "", true, 1},
    {"good",
     {.sun_map = 1024, .blocker_taps = 6, .sun_taps = 8, .sky_taps = 6},
     "shadows and dark folds are grainier",
     true,
     0.75f},
    {"fair",
     {.samples = 1, .sun_map = 1024, .blocker_taps = 4, .sun_taps = 6, .sky_taps = 5},
     "edges are not smoothed (one sample a pixel), shadows are grainier",
     true,
     0.38f},
    {"fast", fast, "no smoothed edges, threads, dark folds or soft shadows", false, 0.30f},
    {"faster", of_resolution(fast, 0.7f),
     "half of the pixels; no smoothed edges, threads, dark folds or soft shadows", false, 0.20f},
    {"fastest", of_resolution(fast, 0.5f),
     "a quarter of the pixels; no smoothed edges, threads, dark folds or soft shadows", false, 0.13f},
};

}  // namespace

std::span<const QualityLevel> quality_levels() {
    return ladder;
}

void QualityChoice::add(float milliseconds, int pixels) {
    static_assert(std::size(ladder) == levels);
    if (std::exchange(pixels_, pixels) != pixels) {
        measured_ = {};
        waiting_ = settling;
        count_ = 0;
    }
    if (waiting_ > 0) {
        --waiting_;
        return;
    }
    times_[count_++] = milliseconds;
    if (count_ < sample) return;
    count_ = 0;
    std::ranges::nth_element(times_, times_.begin() + sample / 2);
    const float now = times_[sample / 2];
    measured_[static_cast<std::size_t>(level_)] = now;
    if (!automatic) return;
    if (now > limit()) {
        int next = level_ + 1;
        while (next < static_cast<int>(levels) - 1 && expected(next, now) > limit()) ++next;
        return move_to(std::min(next, static_cast<int>(levels) - 1));
    }
    if (level_ > 0 && expected(level_ - 1, now) < 0.8f * limit()) move_to(level_ - 1);
}

/// Expected time of a level [ms]: by the ladder's costs, and at least its last median.
float QualityChoice::expected(int level, float now) const {
    const auto there = static_cast<std::size_t>(level), here = static_cast<std::size_t>(level_);
    const float by_cost = now * ladder[there].cost / ladder[here].cost;
    return measured_[there] > 0 ? std::max(measured_[there], by_cost) : by_cost;
}

void QualityChoice::move_to(int level) {
    if (level == level_) return;
    level_ = level;
    waiting_ = settling;
    count_ = 0;
}

void QualityChoice::choose(int level) {
    automatic = false;
    move_to(std::clamp(level, 0, static_cast<int>(levels) - 1));
}

void QualityChoice::start_at(int level) {
    move_to(std::clamp(level, 0, static_cast<int>(levels) - 1));
}

}  // namespace weft::demo
