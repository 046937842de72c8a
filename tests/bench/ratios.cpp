// Frames of two kinds in turn, so that what else the machine does meets both alike: the median of the ratios.

#include <algorithm>
#include <cstdio>
#include <vector>

#include "tests/bench/bench_scenes.h"
#include "tests/bench/frames.h"
#include "tests/bench/stopwatch.h"
#include "tests/embedding/naive_pool.h"

namespace weft::bench {

namespace {

constexpr int pairs = 200;

double quantile(std::vector<double> sample, double part) {
    const auto at =
        sample.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(sample.size() - 1));
    std::ranges::nth_element(sample, at);
    return *at;
}

/// The wall's time: threads of the host have no other clock in common.
void print_ratio(const char* what, Scene& one, Scene& other) {
    std::vector<double> ones, others, ratios;
    for (int pair = 0; pair < pairs; ++pair) {
        const double first = seconds_of(2, [&] { one.frame(); });
        const double second = seconds_of(2, [&] { other.frame(); });
        ones.push_back(1e3 * first);
        others.push_back(1e3 * second);
        ratios.push_back(second / first);
    }
    std::printf("%-52s %8u %9.3f %9.3f %7.2f %5.2f to %.2f\n", what, one.particles(), quantile(ones, 0.5),
                quantile(others, 0.5), quantile(ratios, 0.5), quantile(ratios, 0.25), quantile(ratios, 0.75));
    std::fflush(stdout);
}

WorldSettings on(int threads) {
    WorldSettings world;
    world.threads = threads;
    return world;
}

void print_host_threads(SceneKind kind) {
    if (!has_garment(kind)) return;
    constexpr int threads = 2;
    test::NaivePool pool(threads);
    WorldSettings lent = on(1);
    lent.executor = pool.executor(threads);
    Scene ours(kind, 0, on(threads), {}), hosts(kind, 0, lent, {});
    char what[64];
    std::snprintf(what, sizeof what, "%s: oneTBB, a naive pool; 2 threads", name_of(kind));
    print_ratio(what, ours, hosts);
}

void print_grid(std::uint32_t side, int threads) {
    Scene grid(SceneKind::hanging, side, on(threads), {}),
        mesh(SceneKind::hanging, side, on(threads), {}, true);
    char what[64];
    std::snprintf(what, sizeof what, "hanging sheet: as a grid, as any mesh; %d thread%s", threads,
                  threads == 1 ? "" : "s");
    print_ratio(what, grid, mesh);
}

}  // namespace

void print_ratios() {
    std::printf("%-52s %8s %9s %9s %7s %s\n", "frames in turn: one, the other", "particles", "ms", "ms",
                "ratio", "half of all ratios");
    print_host_threads(SceneKind::garment);
    print_host_threads(SceneKind::dress);
    for (const std::uint32_t side : {128u, 256u})
        for (const int threads : {1, 2}) print_grid(side, threads);
}

}  // namespace weft::bench
