// The scenes in which other cloths were measured, and Bullet's soft bodies in them, in turn with ours.

#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

#include "demo/study/accuracy/motion_measures.h"
#include "engine/vector.h"
#include "tests/bench/bench_scenes.h"
#include "tests/bench/frames.h"
#include "tests/bench/stopwatch.h"
#ifdef WEFT_WITH_BULLET
#include "tests/bench/bullet_sheet.h"
#endif

namespace weft::bench {

namespace {

double median(std::vector<double> sample) {
    std::ranges::nth_element(sample, sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2));
    return sample[sample.size() / 2];
}

struct Setting {
    const char* name;
    ClothSettings cloth;
};

std::vector<Setting> all_settings() {
    std::vector<Setting> settings(3);
    settings[0].name = "default";
    settings[1].name = "1 pass";
    settings[1].cloth.method = Multilevel{.passes = 1};
    settings[2].name = "Jacobi 9, tethers";
    settings[2].cloth.method = Jacobi{.iterations = 9};
    settings[2].cloth.tethers.enabled = true;
    return settings;
}

study::Stretch stretch_of(const Cloth& cloth) {
    std::vector<Eigen::Vector3d> positions;
    for (const Vec4& p : cloth.state.positions.span()) positions.push_back(xyz(p).cast<double>());
    return study::structural_stretch(cloth.model, positions);
}

/// Frames 0.75 s after the start, of ours and Bullet's in turn; stretch after 6 s.
void print_scene(const char* name, SceneKind kind, std::uint32_t side, const std::vector<Setting>& settings) {
    constexpr int timed_frames = 40, frames_before = 45, frames_of_6_s = 360;
    std::vector<Scene> ours;
    for (const Setting& setting : settings) ours.emplace_back(kind, side, 1, setting.cloth, false);
    std::vector<std::vector<double>> times(settings.size());
    std::vector<double> theirs_times;
#ifdef WEFT_WITH_BULLET
    std::unique_ptr<BulletSheet> theirs;  // its self-collision has no effect, so S2 is not its scene
    if (kind != SceneKind::hanging_self)
        theirs = std::make_unique<BulletSheet>(side, kind == SceneKind::draped);
#endif
    for (int frame = 0; frame < timed_frames; ++frame) {
        for (std::size_t k = 0; k < ours.size(); ++k)
            times[k].push_back(1e3 * seconds_of(1, [&] { ours[k].frame(); }));
#ifdef WEFT_WITH_BULLET
        if (theirs) theirs_times.push_back(1e3 * seconds_of(1, [&] { theirs->frame(); }));
#endif
    }
    std::printf("%s %-4u", name, side);
    for (std::size_t k = 0; k < ours.size(); ++k) {
        for (int frame = frames_before + timed_frames; frame < frames_of_6_s; ++frame) ours[k].frame();
        const study::Stretch stretch = stretch_of(ours[k].cloth());
        std::printf("  %8.3f %6.1f %% %5.2f %%", median(times[k]), 100 * (stretch.worst - 1),
                    100 * (stretch.mean - 1));
    }
    if (theirs_times.empty()) {
        std::printf("  %8s\n", "-");
    } else {
        const double bullet = median(theirs_times);
        std::printf("  %8.3f (%.1f and %.1f times)\n", bullet, bullet / median(times[0]),
                    bullet / median(times[1]));
    }
    std::fflush(stdout);
}

}  // namespace

void print_peers() {
    const std::vector<Setting> settings = all_settings();
    std::printf(
        "median ms a frame, one thread; worst and mean stretch of an edge after 6 s; Bullet at 20 "
        "iterations\n%-7s",
        "scene");
    for (const Setting& setting : settings) std::printf("  %25s", setting.name);
    std::printf("  %8s\n", "Bullet");
    const struct {
        const char* name;
        SceneKind kind;
    } scenes[] = {{"S1", SceneKind::hanging}, {"S2", SceneKind::hanging_self}, {"S3", SceneKind::draped}};
    for (const auto& [name, kind] : scenes) {
        for (const std::uint32_t side : {32u, 64u, 128u})
            if (kind != SceneKind::draped || side == 128) print_scene(name, kind, side, settings);
    }
}

}  // namespace weft::bench
