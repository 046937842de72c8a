#pragma once
// The command line of weft_demo.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "demo/simulation.h"

namespace weft::demo {

struct Options {
    std::string scene;  ///< empty: the first, or the garment scene where a garment is given
    SceneOptions scene_options;
    Overrides overrides;
    bool list = false;
    bool headless = false;
    bool panels = false;             ///< draw the panels into headless pictures too
    std::optional<int> frames;       ///< headless default_frames; in a window until it is closed
    int every = 0;                   ///< a picture of every n-th frame; 0: of the last only
    int width = 1280, height = 800;  ///< of window and pictures [pixels]
    std::filesystem::path out = "out";
    std::filesystem::path trace;  ///< empty: none is kept

    static constexpr int default_frames = 120;
};

/// What the program prints instead of running, and the status that it exits with: 0 for --help, 2 for bad
/// arguments.
struct EarlyExit {
    int status = 0;
    std::string text;
};

[[nodiscard]] std::variant<Options, EarlyExit> parse_options(int argc, const char* const* argv);

/// The scene that the options ask for. Error: no scene of that name; one that needs a garment, without it.
[[nodiscard]] Result<const SceneEntry*> choose_scene(const Options& options);

}  // namespace weft::demo
