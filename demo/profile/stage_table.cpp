#include "demo/profile/stage_table.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>

#include "demo/headless/frame_table.h"

namespace weft::demo {
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

}  // namespace weft::demo
