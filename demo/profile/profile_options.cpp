#include "demo/profile/profile_options.h"

#include <CLI/CLI.hpp>

namespace weft::demo {

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
