#include "demo/profile/measurement.h"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <limits>
#include <thread>

#include "demo/headless/frame_table.h"
#include "demo/options/method_table.h"
#include "demo/study/crossings/crossings.h"

#ifdef __linux__
#endif

namespace weft::demo {

#ifdef __linux__

namespace {

int open_counter(std::uint64_t event) {
    perf_event_attr attributes{};
    attributes.type = PERF_TYPE_HARDWARE;
    attributes.size = sizeof attributes;
    attributes.config = event;
    attributes.inherit = 1;  // counts threads that this one starts, too
    attributes.exclude_kernel = 1;
    attributes.exclude_hv = 1;
    return static_cast<int>(syscall(SYS_perf_event_open, &attributes, 0, -1, -1, 0));
}

}  // namespace

HardwareCounters::HardwareCounters()
    : files_{open_counter(PERF_COUNT_HW_CPU_CYCLES), open_counter(PERF_COUNT_HW_INSTRUCTIONS),
             open_counter(PERF_COUNT_HW_CACHE_MISSES)} {}

HardwareCounters::~HardwareCounters() {
    for (const int file : files_)
        if (file >= 0) close(file);
}

std::optional<HardwareCounters::Counts> HardwareCounters::read() const {
    std::array<std::uint64_t, 3> values{};
    for (std::size_t i = 0; i < files_.size(); ++i) {
        if (files_[i] < 0 || ::read(files_[i], &values[i], sizeof values[i]) != sizeof values[i]) return {};
    }
    return Counts{values[0], values[1], values[2]};
}

#else

HardwareCounters::HardwareCounters() : files_{} {}
HardwareCounters::~HardwareCounters() = default;
std::optional<HardwareCounters::Counts> HardwareCounters::read() const {
    return {};
}

#endif

namespace {

double nanoseconds_per_particle(float milliseconds, std::uint32_t particles) {
    return 1e6 * static_cast<double>(milliseconds) / std::max(1u, particles);
}

}  // namespace

void StageTable::add(std::span<const StageTime> stages) {
    constexpr float none = std::numeric_limits<float>::max();
    if (stages_.empty()) {
        for (const StageTime& stage : stages)
            stages_.push_back({stage.name, stage.depth, {}, none, none, none, none});
    }
    for (std::size_t i = 0; i < stages_.size(); ++i) stages_[i].times.push_back(stages[i].last);
}

void StageTable::end_run() {
    for (Stage& stage : stages_) {
        stage.p50 = std::min(stage.p50, percentile(stage.times, 0.50));
        stage.p95 = std::min(stage.p95, percentile(stage.times, 0.95));
        stage.p99 = std::min(stage.p99, percentile(stage.times, 0.99));
        stage.max = std::min(stage.max, percentile(stage.times, 1.00));
        stage.times.clear();
    }
}

std::vector<const StageTable::Stage*> StageTable::step_first() const {
    std::vector<const Stage*> order;
    for (const Stage& stage : stages_) order.push_back(&stage);
    if (!order.empty()) std::rotate(order.begin(), order.end() - 1, order.end());
    return order;
}

std::string StageTable::text(std::uint32_t particles) const {
    constexpr std::size_t line_size = 112;
    char line[line_size];
    std::snprintf(line, line_size, "%-22s %9s %9s %9s %9s %12s\n", "stage [ms]", "p50", "p95", "p99", "max",
                  "ns/particle");
    std::string text = line;
    for (const Stage* stage : step_first()) {
        const std::string name = std::string(2 * static_cast<std::size_t>(stage->depth), ' ') + stage->name;
        std::snprintf(line, line_size, "%-22s %9.3f %9.3f %9.3f %9.3f %12.1f\n", name.c_str(),
                      static_cast<double>(stage->p50), static_cast<double>(stage->p95),
                      static_cast<double>(stage->p99), static_cast<double>(stage->max),
                      nanoseconds_per_particle(stage->p50, particles));
        text += line;
    }
    return text;
}

Result<void> StageTable::write_csv(const std::filesystem::path& file, const Measured& measured) const {
    std::ofstream out(file);
    out << "scene,method,cloths,particles,threads,substeps,frames,bytes_per_particle,stage,depth,p50_ms,p95_"
           "ms,p99_ms,max_ms,ns_per_particle\n";
    for (const Stage* stage : step_first()) {
        out << measured.scene << ',' << measured.method << ',' << measured.cloths << ',' << measured.particles
            << ',' << measured.threads << ',' << measured.substeps << ',' << measured.frames << ','
            << measured.bytes / std::max(1u, measured.particles) << ',' << stage->name << ',' << stage->depth
            << ',' << stage->p50 << ',' << stage->p95 << ',' << stage->p99 << ',' << stage->max << ','
            << nanoseconds_per_particle(stage->p50, measured.particles) << '\n';
    }
    out.close();
    if (!out) return Error{ErrorCode::file_not_found, file.string() + " cannot be written"};
    return {};
}

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

/// Takes the frames before those that are measured. Returns the most particles that one of them stepped.
std::uint32_t warm_up(const ProfileOptions& options, Simulation& simulation) {
    std::uint32_t most = 0;
    for (int frame = 0; frame < options.warm_up; ++frame) {
        simulation.step(frame_seconds);
        most = std::max(most, simulation.world().report().particles);
    }
    return most;
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
                      .particles = 0,
                      .threads = world.settings().threads,
                      .substeps = world.report().substeps,
                      .frames = options.frames,
                      .bytes = 0,
                      .hash = world.state_hash(),
                      .worst_crossings = 0,
                      .processor_ms = 0,
                      .asleep = 0};
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
    std::uint32_t particles = warm_up(options, *simulation);
    int asleep = 0;
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
        const std::uint32_t stepped = simulation->world().report().particles;
        particles = std::max(particles, stepped);
        if (stepped > 0)
            table.add(simulation->world().profile());
        else
            ++asleep;
        if (options.crossings) worst_crossings = std::max(worst_crossings, crossings_in(*simulation));
        progress.update(frame);
    }
    table.end_run();
    Measured measured = describe(options, *simulation);
    measured.particles = particles;
    measured.asleep = asleep;
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

std::variant<ProfileOptions, EarlyExit> parse_profile_options(int argc, const char* const* argv) {
    ProfileOptions options;
    CLI::App app("Weft: where the time of a scene's steps goes, stage by stage.", "weft_profile");
    add_simulation_options(app, options);
    app.add_option("--cloths", options.cloths,
                   "So many cloths: copies of the scene's first, of --particles each, pinned alike")
        ->check(CLI::Range(1, 10'000));
    app.add_option("--frames", options.frames, "Frames of 1/60 s to measure (default: 300)")
        ->check(CLI::Range(1, 1'000'000));
    app.add_option("--warm-up", options.warm_up, "Frames before those (default: 30)")
        ->check(CLI::Range(0, 1'000'000));
    app.add_option("--repeat", options.repeat, "Runs; of each figure the least is shown (default: 1)")
        ->check(CLI::Range(1, 1000));
    app.add_flag("--crossings", options.crossings,
                 "Count the pairs of triangles that cross after each frame, outside the times");
    app.add_option("--csv", options.csv, "Write the table, a row for each stage")->type_name("FILE.csv");
    app.add_option("--trace", options.trace,
                   "Write a timeline of the threads over another 60 frames, for Perfetto or chrome://tracing")
        ->type_name("FILE.json");
    if (auto exit = parse(app, argc, argv)) return *std::move(exit);
    return options;
}

}  // namespace weft::demo
