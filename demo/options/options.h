#pragma once
// The command line of weft_demo.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <variant>

#include "demo/export/sequence.h"
#include "demo/options/simulation_options.h"

namespace weft::demo {

struct Options : SimulationOptions {
    bool headless = false;
    bool panels = false;             ///< draw the panels into headless pictures too
    std::optional<int> frames;       ///< empty: headless default_frames; in a window until it is closed
    int every = 0;                   ///< a picture of every n-th frame too; 0: of the last only
    int width = 1280, height = 800;  ///< of window and pictures [pixels]
    double turn = 0;                 ///< angle of the camera round the scene, from its own place [degrees]
    std::filesystem::path out = "out";
    std::optional<SequenceFormat> sequence;  ///< format of the frames' cloth in `out`; none: none is written
    std::filesystem::path trace;             ///< empty: none is kept
    bool check_gl = false;                   ///< the driver checks each call

    static constexpr int default_frames = 120;
};

[[nodiscard]] std::variant<Options, EarlyExit> parse_options(int argc, const char* const* argv);

}  // namespace weft::demo
