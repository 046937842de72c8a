#include "demo/options.h"

#include <charconv>
#include <CLI/CLI.hpp>
#include <cmath>
#include <span>

#include "demo/methods.h"

namespace weft::demo {
namespace {

/// "1,-2.5,0" or "1280x800": exactly as many numbers as `values` holds, with `separator` between them.
template <class T>
bool parse_numbers(const std::string& text, char separator, std::span<T> values) {
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

std::string parse_wind(const std::string& text, std::optional<Vec3>& wind) {
    std::array<float, 3> v{};
    const bool parsed = parse_numbers<float>(text, ',', v);
    const float speed = std::hypot(v[0], v[1], v[2]);
    if (!parsed || !(speed <= 100))
        return text + " is not a wind; X,Y,Z in m/s and at most 100 m/s are, as in 5,0,-1";
    wind = Vec3{v[0], v[1], v[2]};
    return {};
}

std::string parse_size(const std::string& text, Options& options) {
    std::array<int, 2> size{};
    const auto fits = [](int pixels) { return pixels >= 16 && pixels <= 8192; };
    if (!parse_numbers<int>(text, 'x', size) || !fits(size[0]) || !fits(size[1])) {
        return text + " is not a size; WIDTHxHEIGHT from 16 to 8192 pixels is, as in 1280x800";
    }
    options.width = size[0];
    options.height = size[1];
    return {};
}

std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const NamedMethod& each : all_methods()) names.emplace_back(each.name);
    return names;
}

void describe(CLI::App& app, Options& options) {
    app.add_flag("--list", options.list, "List the scenes and exit");
    app.add_option("--scene", options.scene, "Scene to start, one of --list");
    app.add_option(
           "--garment", options.scene_options.garment,
           "OBJ file for the scene garment: +Z up, texture coordinates are its flat pattern in metres")
        ->type_name("FILE.obj");
    app.add_option("--particles", options.scene_options.particles,
                   "About this many particles (default: the scene's own number)")
        ->check(CLI::Range(9u, 4u << 20));
    app.add_option("--threads", options.overrides.threads,
                   "Threads of the simulation (default: one per core)")
        ->check(CLI::Range(1, 256));
    app.add_option_function<std::string>(
           "--wind",
           [&options](const std::string& text) {
               if (auto error = parse_wind(text, options.overrides.wind); !error.empty()) {
                   throw CLI::ValidationError("--wind", error);
               }
           },
           "Wind [m/s]")
        ->type_name("X,Y,Z");
    app.add_option_function<std::string>(
           "--method",
           [&options](const std::string& name) { options.overrides.method = find_method(name)->method; },
           "How the cloth is stepped (default: the scene's own)")
        ->check(CLI::IsMember(method_names()));
    app.add_option("--iterations", options.overrides.iterations,
                   "Iterations of the method in each of its substeps")
        ->check(CLI::Range(0, 10000));
    app.add_option("--substeps", options.overrides.substeps, "Steps of the solver in each 1/60 s")
        ->check(CLI::Range(1, 256));
    app.add_option("--self-collision", options.overrides.self_collision,
                   "1 on, 0 off (default: the scene's own)");
    app.add_flag("--headless", options.headless,
                 "No window: simulate --frames, leave pictures and tables in --out");
    app.add_flag("--panels", options.panels, "Draw the panels into headless pictures too")
        ->needs("--headless");
    app.add_option("--frames", options.frames, "Frames of 1/60 s to run (headless default: 120)")
        ->check(CLI::Range(1, 10'000'000));
    app.add_option("--every", options.every, "Headless: a picture of every n-th frame, not of the last alone")
        ->check(CLI::Range(1, 10'000'000));
    app.add_option("--out", options.out, "Folder for what a headless run leaves (default: out)")
        ->type_name("DIR");
    app.add_option_function<std::string>(
           "--size",
           [&options](const std::string& text) {
               if (auto error = parse_size(text, options); !error.empty())
                   throw CLI::ValidationError("--size", error);
           },
           "Size of window and pictures [pixels] (default: 1280x800)")
        ->type_name("WxH");
    app.add_option("--trace", options.trace, "Write the stages' times for Perfetto or chrome://tracing")
        ->type_name("FILE.json");
}

}  // namespace

std::variant<Options, EarlyExit> parse_options(int argc, const char* const* argv) {
    Options options;
    CLI::App app(
        "Weft: cloth in the wind. Left drag grabs cloth or orbits, the wheel zooms, arrow keys steer the "
        "wind.",
        "weft_demo");
    describe(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return EarlyExit{0, app.help()};
    } catch (const CLI::ParseError& error) {
        return EarlyExit{2, std::string(error.what()) + " (--help lists the options)\n"};
    }
    return options;
}

Result<const SceneEntry*> choose_scene(const Options& options) {
    const bool garment_given = !options.scene_options.garment.empty();
    std::string name = options.scene;
    if (name.empty()) name = garment_given ? "garment" : all_scenes().front().name;

    const SceneEntry* scene = find_scene(name);
    if (scene == nullptr) {
        return Error{ErrorCode::invalid_argument,
                     "there is no scene " + name + "; --list shows those there are"};
    }
    if (scene->needs_garment && !garment_given) {
        return Error{ErrorCode::invalid_argument,
                     "scene " + name + " needs an OBJ file; name one with --garment"};
    }
    return scene;
}

}  // namespace weft::demo
