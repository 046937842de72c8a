#pragma once
// The command line of weft_profile.

#include <filesystem>
#include <variant>

#include "demo/options/simulation_options.h"

namespace weft::demo {

struct ProfileOptions : SimulationOptions {
    int cloths = 1;               ///< the scene's own and copies of its first
    int warm_up = 30;             ///< frames before the measured ones
    int frames = 300;             ///< measured frames
    bool crossings = false;       ///< count those after each measured frame
    int repeat = 1;               ///< runs; of each figure the least is shown, since noise only adds
    std::filesystem::path csv;    ///< empty: none is written
    std::filesystem::path trace;  ///< empty: none is kept
};

[[nodiscard]] std::variant<ProfileOptions, EarlyExit> parse_profile_options(int argc,
                                                                            const char* const* argv);

}  // namespace weft::demo
