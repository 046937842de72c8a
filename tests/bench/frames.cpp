#include "tests/bench/frames.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tests/bench/kernels.h"
#include "tests/bench/roof.h"
#include "tests/bench/stopwatch.h"

namespace weft::bench {

namespace {

constexpr int frames = 30, stage_frames = 12;
constexpr std::uint32_t sides[] = {32, 64, 128, 256, 512};

std::vector<int> thread_counts() {
    std::vector<int> counts;
    const int cores = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 256);
    for (int threads = 1; threads < cores; threads *= 2) counts.push_back(threads);
    counts.push_back(cores);
    return counts;
}

struct Place {
    SceneKind kind;
    std::uint32_t side;
    int threads;

    [[nodiscard]] std::string name() const {
        const std::string size = kind == SceneKind::garment ? "" : "/" + std::to_string(side);
        return std::string(name_of(kind)) + size + "/threads:" + std::to_string(threads);
    }
};

std::vector<Place> places(SceneKind kind) {
    std::vector<Place> all;
    for (const int threads : thread_counts()) {
        if (kind == SceneKind::garment) {
            if (has_garment()) all.push_back({kind, 0, threads});
            continue;
        }
        for (const std::uint32_t side : sides) all.push_back({kind, side, threads});
    }
    return all;
}

/// The time is the mean, as ever; ns/particle is of a fast run, which on a machine that others use says more:
/// one that a thousandth of all beat, as a virtual machine's CPU clock now and then stands still.
template <class Seconds>
void measure(benchmark::State& state, double particles, const Seconds& seconds) {
    std::vector<double> all;
    for (auto _ : state) {
        const double once = seconds();
        state.SetIterationTime(once);
        all.push_back(once);
    }
    const auto fast = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 1000);
    std::ranges::nth_element(all, fast);
    state.counters["ns/particle"] = 1e9 * *fast / particles;
    state.counters["particles"] = particles;
}

void measure_kernel(benchmark::State& state, const Place& place, const std::string& name) {
    static std::string kept;  // the kernels of one place at a time, and of the scene that is cached then
    static std::optional<Kernels> kernels;
    if (kept != place.name()) kernels.reset();
    Scene& scene =
        cached_scene(place.name(), [&] { return Scene(place.kind, place.side, place.threads, {}); });
    if (!kernels) kernels.emplace(scene);
    kept = place.name();
    measure(state, scene.particles(), kernels->find(name)->seconds);
}

void measure_frames(benchmark::State& state, const Place& place, const std::string& name,
                    const ClothSettings& settings) {
    Scene& scene = cached_scene(name, [&] { return Scene(place.kind, place.side, place.threads, settings); });
    measure(state, scene.particles(), [&] { return seconds_of(place.threads, [&] { scene.frame(); }); });
}

struct NamedSettings {
    const char* name;
    ClothSettings settings;
};

std::vector<NamedSettings> methods() {
    const auto with = [](const Method& method, int substeps = 1) {
        ClothSettings settings;
        settings.method = method;
        settings.substeps = substeps;
        return settings;
    };
    std::vector<NamedSettings> all{{"default", {}},
                                   {"multilevel-1", with(Multilevel{.passes = 1})},
                                   {"jacobi", with(Jacobi{})},
                                   {"chebyshev", with(Chebyshev{})},
                                   {"conjugate-gradient", with(ConjugateGradient{})},
                                   {"xpbd-8-substeps", with(Xpbd{}, 8)},
                                   {"fibres", with(Fibres{})},
                                   {"default-bdf2", {}},
                                   {"default-elements", {}}};
    all[all.size() - 2].settings.time_scheme = TimeScheme::bdf2;
    all.back().settings.finite_elements.enabled = true;
    return all;
}

void register_frames(const NamedSettings& method, SceneKind kind) {
    for (const Place& place : places(kind)) {
        const std::string name = std::string("frame/") + method.name + "/" + place.name();
        benchmark::RegisterBenchmark(name.c_str(),
                                     [=, settings = method.settings](benchmark::State& state) {
                                         measure_frames(state, place, name, settings);
                                     })
            ->UseManualTime()
            ->Iterations(frames)
            ->Unit(benchmark::kMillisecond);
    }
}

}  // namespace

void register_benchmarks() {
    for (const SceneKind kind : {SceneKind::draped, SceneKind::garment}) {
        for (const Place& place : places(kind)) {
            for (const KernelName& kernel : Kernels::names()) {
                const std::string name = "kernel/" + kernel.name + "/" + place.name();
                auto* const made = benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
                    measure_kernel(state, place, kernel.name);
                });
                made->UseManualTime()->Unit(benchmark::kMicrosecond);
                if (kernel.is_stage) made->Iterations(stage_frames);  // each of them takes a whole frame
            }
        }
    }
    for (const NamedSettings& method : methods()) {
        register_frames(method, SceneKind::hanging);
        const bool is_default = method.name == std::string("default");
        if (is_default) register_frames(method, SceneKind::draped);
        register_frames(method, SceneKind::garment);
    }
}

void print_roofline(int threads) {
    const Roof roof = measure_roof(threads);
    std::printf("%d threads, vectors of %s: %.1f GFLOP/s; reads of a working set:", threads, roof.target,
                1e-9 * roof.flops);
    for (const ReadRate& rate : roof.reads)
        std::printf(" %.1f MB %.1f GB/s%s", 1e-6 * static_cast<double>(rate.bytes),
                    1e-9 * rate.bytes_per_second, &rate == &roof.reads.back() ? "" : ",");
    for (const std::uint32_t side : {64u, 128u, 256u}) {
        Scene scene(SceneKind::draped, side, threads, {});
        const Kernels kernels(scene);
        const double n = scene.particles();
        std::printf(
            "\n\ndraped sheet, %u x %u, %.1f contacts per 100 particles; per particle\n%-18s %8s %8s %9s %9s "
            "%6s\n",
            side, side, 100 * scene.cloth().self_counts.pairs / n, "kernel", "bytes", "flops", "ns",
            "least ns", "roof");
        for (const Kernel& kernel : kernels.list()) {
            double best = kernel.seconds();
            for (int k = 0; k < 10; ++k) best = std::min(best, kernel.seconds());
            const Traffic& t = kernel.traffic;
            const double least = roof.least_seconds(t.bytes * n, t.flops * n, t.bytes * n);
            std::printf("%-18s %8.0f %8.0f %9.2f %9.2f %5.0f%%\n", kernel.name.c_str(), t.bytes, t.flops,
                        1e9 * best / n, 1e9 * least / n, 100 * least / best);
        }
    }
}

}  // namespace weft::bench
