#include "demo/profile/measurement.h"

#include <algorithm>
#include <ctime>
#include <thread>

#include "demo/headless/progress.h"
#include "demo/options/method_table.h"
#include "demo/study/crossings/crossings.h"

namespace weft::demo {
namespace {

constexpr float frame_seconds = 1.0f / 60.0f;
constexpr int traced_frames = 60;

Result<void> add_copy(World& world, const SceneCloth& original) {
    const auto settings = world.cloth_settings(original.id);
    if (!settings) return settings.error();
    const auto copy = world.add_cloth(original.mesh, *settings);
    if (!copy) return copy.error();
    const auto view = world.cloth(original.id);
    if (!view) return view.error();
    for (std::uint32_t vertex = 0; vertex < view->vertex_to_particle.size(); ++vertex) {
        if (view->positions[view->vertex_to_particle[vertex]].w != 0) continue;
        if (auto pinned = world.pin(*copy, vertex); !pinned) return pinned.error();
    }
    return {};
}

void warm_up(const ProfileOptions& options, Simulation& simulation) {
    for (int frame = 0; frame < options.warm_up; ++frame) simulation.step(frame_seconds);
}

std::uint64_t crossings_in(Simulation& simulation) {
    study::TriangleSoup soup;
    for (const SceneCloth& cloth : simulation.content().cloths)
        if (const auto view = simulation.world().cloth(cloth.id)) soup.add(*view);
    return study::count_crossings(soup).all;
}

Measured describe(const ProfileOptions& options, Simulation& simulation) {
    const World& world = simulation.world();
    Measured measured{.scene = simulation.entry().name,
                      .method = {},
                      .cloths = static_cast<int>(world.report().cloths),
                      .particles = world.report().particles,
                      .threads = world.settings().threads,
                      .substeps = world.report().substeps,
                      .frames = options.frames,
                      .bytes = 0,
                      .hash = world.state_hash(),
                      .worst_crossings = 0,
                      .processor_ms = 0};
    if (measured.threads == 0) measured.threads = static_cast<int>(std::thread::hardware_concurrency());
    const std::vector<SceneCloth>& cloths = simulation.content().cloths;
    for (const SceneCloth& cloth : cloths)
        if (const auto info = world.cloth_info(cloth.id)) measured.bytes += info->bytes;
    const auto copies = static_cast<std::uint64_t>(measured.cloths) - cloths.size();
    if (const auto info = world.cloth_info(cloths.front().id)) measured.bytes += copies * info->bytes;
    if (const auto settings = world.cloth_settings(cloths.front().id))
        measured.method = entry_of(settings->method).name;
    return measured;
}

}  // namespace

Result<Simulation> build_simulation(const ProfileOptions& options) {
    auto simulation = start_simulation(options);
    if (!simulation) return simulation;
    const std::vector<SceneCloth>& own = simulation->content().cloths;
    for (int i = static_cast<int>(own.size()); i < options.cloths; ++i) {
        if (auto added = add_copy(simulation->world(), own.front()); !added) return added.error();
    }
    return simulation;
}

Result<Measured> measure(const ProfileOptions& options, const HardwareCounters& counters, StageTable& table,
                         std::optional<HardwareCounters::Counts>& counts) {
    auto simulation = build_simulation(options);
    if (!simulation) return simulation.error();
    warm_up(options, *simulation);
    Progress progress(simulation->entry().name, options.frames);
    std::uint64_t worst_crossings = 0;
    std::clock_t processor_time = 0;
    for (int frame = 1; frame <= options.frames; ++frame) {
        const auto before = counters.read();
        const std::clock_t start = std::clock();
        simulation->step(frame_seconds);
        processor_time += std::clock() - start;
        const auto after = counters.read();
        if (before && after) (counts ? *counts : counts.emplace()) += *after - *before;
        table.add(simulation->world().profile());
        if (options.crossings) worst_crossings = std::max(worst_crossings, crossings_in(*simulation));
        progress.update(frame);
    }
    table.end_run();
    Measured measured = describe(options, *simulation);
    measured.worst_crossings = worst_crossings;
    measured.processor_ms =
        1e3 * static_cast<double>(processor_time) / (static_cast<double>(CLOCKS_PER_SEC) * options.frames);
    return measured;
}

Result<void> trace(const ProfileOptions& options) {
    auto simulation = build_simulation(options);
    if (!simulation) return simulation.error();
    warm_up(options, *simulation);
    if (auto started = simulation->world().start_trace(); !started) return started;
    for (int frame = 0; frame < std::min(options.frames, traced_frames); ++frame)
        simulation->step(frame_seconds);
    return simulation->world().write_trace(options.trace);
}

}  // namespace weft::demo
