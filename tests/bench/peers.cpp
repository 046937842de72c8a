// The scenes in which other cloths were measured, and Bullet's soft bodies in them, in turn with ours.

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include "tests/bench/frames.h"
#include "tests/bench/scenes.h"
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
    Method method;
};

}  // namespace

void print_peers() {
    constexpr int frames = 40;
    const Setting settings[] = {{"default", Multilevel{}},
                                {"1 pass", Multilevel{.passes = 1, .iterations = 1}}};
    const struct {
        const char* name;
        SceneKind kind;
    } scenes[] = {{"S1", SceneKind::hanging}, {"S2", SceneKind::hanging_self}, {"S3", SceneKind::draped}};
    std::printf(
        "median ms a frame, one thread; Bullet at 20 iterations, and how many times as long it takes\n");
    std::printf("%-10s %9s %9s %9s %12s %12s\n", "scene", "default", "1 pass", "Bullet", "per default",
                "per 1 pass");
    for (const auto& [name, kind] : scenes) {
        for (const std::uint32_t side : {32u, 64u, 128u}) {
            if (kind == SceneKind::draped && side != 128) continue;
            std::vector<Scene> ours;
            for (const Setting& setting : settings) {
                ClothSettings cloth;
                cloth.method = setting.method;
                ours.emplace_back(kind, side, 1, cloth, false);
            }
            std::vector<double> times[3];
#ifdef WEFT_WITH_BULLET
            std::unique_ptr<BulletSheet> theirs;  // its self-collision has no effect, so S2 is not its scene
            if (kind != SceneKind::hanging_self)
                theirs = std::make_unique<BulletSheet>(side, kind == SceneKind::draped);
#endif
            for (int frame = 0; frame < frames; ++frame) {
                for (std::size_t k = 0; k < 2; ++k)
                    times[k].push_back(1e3 * seconds_of(1, [&] { ours[k].frame(); }));
#ifdef WEFT_WITH_BULLET
                if (theirs) times[2].push_back(1e3 * seconds_of(1, [&] { theirs->frame(); }));
#endif
            }
            const double normal = median(times[0]), quick = median(times[1]);
            std::printf("%s %-7u %9.3f %9.3f", name, side, normal, quick);
            if (times[2].empty()) {
                std::printf(" %9s %12s %12s\n", "-", "-", "-");
            } else {
                const double bullet = median(times[2]);
                std::printf(" %9.3f %12.2f %12.2f\n", bullet, bullet / normal, bullet / quick);
            }
        }
    }
}

}  // namespace weft::bench
