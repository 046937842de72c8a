// weft_profile: where the time of a scene's steps goes.

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <utility>
#include <variant>

#include "demo/profile/measurement.h"

namespace {

using namespace weft::demo;

int fail(int status, const weft::Error& error) {
    std::fprintf(stderr, "weft_profile: %s\n", error.message.c_str());
    return status;
}

void print(const Measured& measured, int repeat) {
    std::printf("scene %s, %d cloth%s, %u particles, %d thread%s, %s, %d substeps, %d frames",  //
                measured.scene.c_str(), measured.cloths, measured.cloths == 1 ? "" : "s", measured.particles,
                measured.threads, measured.threads == 1 ? "" : "s", measured.method.c_str(),
                measured.substeps, measured.frames);
    if (repeat > 1) std::printf(", least of %d runs", repeat);
    std::printf("\n%" PRIu64 " bytes per particle\n", measured.bytes / std::max(1u, measured.particles));
    std::printf("%.3f ms of the processor a frame, mean of the %srun\n", measured.processor_ms,
                repeat > 1 ? "last " : "");
}

void print(const HardwareCounters::Counts& counts, double particles_stepped) {
    std::printf("per particle and step: %.0f cycles, %.0f instructions, %.2f cache misses\n",
                static_cast<double>(counts.cycles) / particles_stepped,
                static_cast<double>(counts.instructions) / particles_stepped,
                static_cast<double>(counts.cache_misses) / particles_stepped);
}

int run(const ProfileOptions& options) {
    for (const auto& [option, file] :
         {std::pair("--csv", options.csv), std::pair("--trace", options.trace)}) {
        if (auto writable = check_writable(option, file); !writable) return fail(2, writable.error());
    }
    const HardwareCounters counters;
    StageTable table;
    Measured measured;
    std::optional<HardwareCounters::Counts> counts;
    for (int i = 0; i < options.repeat; ++i) {
        auto result = measure(options, counters, table, counts);
        if (!result) return fail(2, result.error());
        measured = *std::move(result);
    }
    print(measured, options.repeat);
    if (measured.asleep > 0)
        std::printf("asleep in %d of %d frames, which are not in the table\n", measured.asleep,
                    measured.frames);
    if (options.crossings)
        std::printf("%" PRIu64 " pairs of triangles cross at the worst\n", measured.worst_crossings);
    std::fputs(table.text(measured.particles).c_str(), stdout);
    if (counts)
        print(*counts, 1.0 * measured.particles * (measured.frames - measured.asleep) * options.repeat);
    std::printf("hash: %016" PRIx64 "\n", measured.hash);

    if (!options.csv.empty())
        if (const auto written = table.write_csv(options.csv, measured); !written)
            return fail(1, written.error());
    if (!options.trace.empty())
        if (const auto written = trace(options); !written) return fail(1, written.error());
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const auto parsed = parse_profile_options(argc, argv);
    if (const auto* exit = std::get_if<EarlyExit>(&parsed)) {
        std::fputs(exit->text.c_str(), exit->status == 0 ? stdout : stderr);
        return ended("weft_profile", exit->status);
    }
    const auto& options = std::get<ProfileOptions>(parsed);
    if (options.list) {
        std::fputs(scene_list().c_str(), stdout);
        return ended("weft_profile", 0);
    }
    return ended("weft_profile", run(options));
}
