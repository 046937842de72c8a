// weft_replay: a recording's steps, taken again and compared.

#include <cinttypes>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "weft/weft.h"

namespace {

constexpr int same = 0, different = 1, bad_file = 2;

int tell(const weft::Replay& replay) {
    std::printf("%" PRIu64 " steps, %" PRIu64 " calls besides\n", replay.steps, replay.calls);
    if (replay.difference) {
        const std::string what =
            replay.difference->cloth
                ? "cloth " + std::to_string(*replay.difference->cloth) +
                      ", counted as they were added from 0,"
                : "what there is besides cloths: colliders, bodies, shapes or the wind's way";
        std::printf("step %" PRIu64 " is the first that differs: %s has other bytes\n",
                    replay.difference->step, what.c_str());
        return different;
    }
    if (!replay.is_whole) std::puts("it breaks off there, without its end");
    std::puts("the same bytes");
    return same;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "Weft: takes the steps of a recording again, and compares. Exit status: 0 the same bytes, 1 other "
        "bytes, "
        "2 no recording.",
        "weft_replay");
    std::string file;
    weft::ReplayOptions options;
    app.add_option("FILE", file, "What weft_demo --record or World::start_recording left")->required();
    app.add_option("--threads", options.threads, "Threads of the simulation (default: one per core)")
        ->check(CLI::Range(1, 256));
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::fputs(app.help().c_str(), stdout);
        return 0;
    } catch (const CLI::ParseError& error) {
        std::fprintf(stderr, "%s (--help lists the options)\n", error.what());
        return bad_file;
    }
    const auto replayed = weft::replay(std::filesystem::path(file), options);
    if (replayed) return tell(*replayed);
    std::fprintf(stderr, "weft_replay: %s\n", replayed.error().message.c_str());
    return bad_file;
}
