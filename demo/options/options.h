#pragma once
// The options of weft_demo, and those that it shares with weft_profile: the scene, and changes to it.

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "demo/export/sequence.h"
#include "demo/scene_simulation.h"

namespace CLI {
class App;
}

namespace weft::demo {

struct SimulationOptions {
    bool list = false;  ///< print scene_list() instead of running
    std::string scene;  ///< empty: the first, or the garment scene where a garment is given
    SceneOptions scene_options;
    Overrides overrides;
    std::filesystem::path settings;  ///< JSON file; empty: none
};

/// Text that the program prints instead of running, and its exit status: 0 for --help, 2 for bad arguments.
struct EarlyExit {
    int status = 0;
    std::string text;
};

void add_simulation_options(CLI::App& app, SimulationOptions& options);

/// Checks before a long run that a file can be written; an existing file stays as it is. Error: it cannot be
/// written. An empty path passes.
[[nodiscard]] Result<void> check_writable(const char* option, const std::filesystem::path& file);

/// The exit status: 1 in place of 0, with a line on standard error, if standard output lost text, as on a
/// full disk.
[[nodiscard]] int ended(const char* program, int status);

/// A line for each scene.
[[nodiscard]] std::string scene_list();

/// The scene that the options ask for. Error: no scene of that name; one that needs a garment, without it;
/// one that has none, with it.
[[nodiscard]] Result<const SceneEntry*> choose_scene(const SimulationOptions& options);

/// Builds the scene, applies its file of settings, then the explicit options. Errors: choose_scene()'s,
/// Simulation::create()'s, load_settings()'s.
[[nodiscard]] Result<Simulation> start_simulation(const SimulationOptions& options);

/// Parses the arguments into the app's options; empty: success.
[[nodiscard]] std::optional<EarlyExit> parse(CLI::App& app, int argc, const char* const* argv);

/// "1,-2.5,0" or "1280x800": exactly as many numbers as `values` holds, with `separator` between them.
template <class T>
[[nodiscard]] bool parse_numbers(const std::string& text, char separator, std::span<T> values) {
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0 && (at == end || *at++ != separator)) return false;
        const auto [next, error] = std::from_chars(at, end, values[i]);
        if (error != std::errc{}) return false;
        at = next;
    }
    return at == end;
}

/// The command line of weft_demo.
struct Options : SimulationOptions {
    bool headless = false;
    bool panels = false;             ///< draw the panels into headless pictures too
    std::optional<int> frames;       ///< empty: headless default_frames; in a window until it is closed
    int every = 0;                   ///< a picture of every n-th frame too; 0: of the last only
    int width = 1280, height = 800;  ///< of window and pictures [pixels]
    double turn = 0;                 ///< angle of the camera round the scene, from its own place [degrees]
    std::filesystem::path out = "out";
    std::optional<SequenceFormat> sequence;  ///< format of the frames' cloth in `out`; none: none is written
    std::optional<Method> compare;           ///< a second simulation by this method stands beside the first
    std::filesystem::path trace;             ///< empty: none is kept
    bool check_gl = false;                   ///< the driver checks each call

    static constexpr int default_frames = 120;
};

[[nodiscard]] std::variant<Options, EarlyExit> parse_options(int argc, const char* const* argv);

}  // namespace weft::demo
