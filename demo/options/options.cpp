#include "demo/options/options.h"

#include <array>
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <system_error>
#include <vector>

#include "demo/look/settings_file.h"
#include "demo/options/fabric_file.h"
#include "demo/options/method_table.h"
#include "demo/window/wind_control.h"

namespace weft::demo {

namespace {

std::string parse_wind(const std::string& text, std::optional<Vec3>& wind) {
    std::array<float, 3> v{};
    const bool parsed = parse_numbers<float>(text, ',', v);
    const float speed = std::hypot(v[0], v[1], v[2]);
    if (!parsed || !(speed <= WindControl::max_speed))
        return text + " is not a wind; X,Y,Z in m/s and at most 100 m/s are, as in 5,0,-1";
    wind = Vec3{v[0], v[1], v[2]};
    return {};
}

std::string fabric_help() {
    std::string help("What the cloth is made of (default: the scene's own):");
    for (const NamedFabric& each : fabrics())
        help.append(&each == &fabrics().front() ? " " : ", ").append(each.name);
    return help.append(", or a file, or stiffening: and a measured file, see demo/options/fabric_file.h");
}

std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const NamedMethod& each : all_methods()) names.emplace_back(each.name);
    return names;
}

}  // namespace

void add_simulation_options(CLI::App& app, SimulationOptions& options) {
    app.add_flag("--list", options.list, "List the scenes and exit");
    app.add_option("--scene", options.scene, "Scene to start, one of --list");
    app.add_option("--garment", options.scene_options.garment,
                   "OBJ file for the scene garment: +Z up, texture coordinates are its flat pattern in "
                   "metres; or glTF. "
                   "For character and crowd see demo/README.md")
        ->type_name("FILE");
    const std::map<std::string, Hold> holds{{"opening", Hold::highest_opening},
                                            {"top", Hold::top},
                                            {"border", Hold::border},
                                            {"nothing", Hold::nothing}};
    app.add_option("--hold", options.scene_options.hold, "What holds the garment (default: opening)")
        ->transform(CLI::CheckedTransformer(holds).description("opening, top, border or nothing"));
    const std::map<std::string, float> units{{"m", 1.0f}, {"cm", 0.01f}, {"mm", 0.001f}, {"in", 0.0254f}};
    app.add_option("--unit", options.scene_options.unit, "Of the garment's file (default: by its size)")
        ->transform(CLI::CheckedTransformer(units).description("m, cm, mm or in"));
    app.add_option("--settings", options.settings,
                   "JSON file of scene, wind, material and method, as the panels save it")
        ->type_name("FILE.json");
    app.add_option("--motion", options.scene_options.motion,
                   "BVH file for the scene character (default: a walk that ships), or a pipe of joints")
        ->type_name("FILE.bvh");
    app.add_option("--speed", options.scene_options.speed, "Of the motion, times its own")
        ->check(CLI::Range(0.0, 10.0));
    app.add_option_function<std::string>(
           "--body", [&options](const std::string& name) { options.scene_options.skin = name == "skin"; },
           "What of the body cloth meets: capsules of limbs (default), or skin, triangles that follow them")
        ->check(CLI::IsMember({"capsules", "skin"}));
    app.add_option("--particles", options.scene_options.particles,
                   "About this many particles (default: the scene's own number)")
        ->check(CLI::Range(9u, 4u << 20));
    app.add_option("--simulate", options.scene_options.simulated,
                   "Simulate a mesh of about this many particles, and draw the file's own mesh "
                   "over it (default: the file's own mesh is simulated)")
        ->check(CLI::Range(12u, 1u << 20));
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
    app.add_option_function<std::string>(
           "--fabric",
           [&options](const std::string& name) {
               const auto fabric = find_fabric(name);
               if (!fabric) throw CLI::ValidationError("--fabric", fabric.error().message);
               options.overrides.fabric = *fabric;
           },
           fabric_help())
        ->type_name("NAME|FILE.json");
    app.add_option("--iterations", options.overrides.iterations,
                   "Iterations of the method in each of its substeps")
        ->check(CLI::Range(1, 10000));
    app.add_option("--substeps", options.overrides.substeps, "Steps of the solver in each 1/60 s")
        ->check(CLI::Range(1, 256));
    std::map<std::string, SelfCollisionMethod> names;
    for (const SelfCollisionMethod method : self_collision_methods) names[name_of(method)] = method;
    app.add_option("--contact", options.overrides.contact,
                   "How cloth is kept from passing through cloth (default: the scene's own)")
        ->transform(CLI::CheckedTransformer(names).description("off, avoidance, impact-zones or contact"));
}

std::optional<EarlyExit> parse(CLI::App& app, int argc, const char* const* argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return EarlyExit{0, app.help()};
    } catch (const CLI::ExtrasError&) {
        std::string unknown;
        for (const std::string& each : app.remaining()) unknown.append(" ").append(each);
        return EarlyExit{2, "there is no option" + unknown + " (--help lists those there are)\n"};
    } catch (const CLI::ParseError& error) {
        return EarlyExit{2, std::string(error.what()) + " (--help lists the options)\n"};
    }
    return {};
}

Result<void> check_writable(const char* option, const std::filesystem::path& file) {
    if (file.empty()) return {};
    std::error_code ignored;
    const bool existed = std::filesystem::exists(file, ignored);
    const bool writable = std::ofstream(file, std::ios::app).is_open();
    if (writable && !existed) std::filesystem::remove(file, ignored);
    if (writable) return {};
    return Error{ErrorCode::file_not_found, std::string(option) + " " + file.string() +
                                                " cannot be written; its folder must exist and be writable"};
}

int ended(const char* program, int status) {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
    std::fprintf(stderr, "%s: standard output cannot be written\n", program);
    return status == 0 ? 1 : status;
}

std::string scene_list() {
    std::string list;
    for (const SceneEntry& scene : all_scenes()) {
        char line[160];
        std::snprintf(line, sizeof line, "%-11s%s%s\n", scene.name, scene.description,
                      scene.needs_garment ? " (--garment)" : "");
        list += line;
    }
    return list;
}

Result<const SceneEntry*> choose_scene(const SimulationOptions& options) {
    const bool garment_given = !options.scene_options.garment.empty();
    std::string name = options.scene;
    if (name.empty() && !options.settings.empty()) {
        auto named = scene_of_settings(options.settings);
        if (!named) return named.error();
        name = *named;
    }
    if (name.empty() && !options.scene_options.motion.empty()) name = "character";
    if (name.empty()) name = garment_given ? "garment" : all_scenes().front().name;

    const SceneEntry* scene = find_scene(name);
    if (scene == nullptr) {
        return Error{ErrorCode::invalid_argument,
                     "there is no scene " + name + "; --list shows those there are"};
    }
    if (scene->needs_garment && !garment_given) {
        return Error{ErrorCode::invalid_argument,
                     "scene " + name + " needs an OBJ or glTF file; name one with --garment"};
    }
    if (!scene->takes_garment && garment_given) {
        return Error{ErrorCode::invalid_argument, "scene " + name + " has no garment; leave out --garment " +
                                                      options.scene_options.garment.string() +
                                                      ", or name the scene garment"};
    }
    if (!garment_given && options.scene_options.simulated > 0) {
        return Error{ErrorCode::invalid_argument,
                     "scene " + name +
                         " has no mesh of a file to draw over what is simulated; leave out "
                         "--simulate, or name a file with --garment"};
    }
    if (!scene->takes_motion && !options.scene_options.motion.empty()) {
        return Error{ErrorCode::invalid_argument,
                     "scene " + name + " has nobody to move; leave out --motion " +
                         options.scene_options.motion.string() + ", or name the scene character"};
    }
    if (!scene->takes_motion && (options.scene_options.skin || options.scene_options.speed != 1)) {
        return Error{ErrorCode::invalid_argument, "scene " + name +
                                                      " has nobody to move; leave out --body and --speed, or "
                                                      "name the scene character"};
    }
    return scene;
}

Result<Simulation> start_simulation(const SimulationOptions& options) {
    const auto scene = choose_scene(options);
    if (!scene) return scene.error();
    auto simulation = Simulation::create(**scene, options.scene_options, options.overrides);
    if (!simulation || options.settings.empty()) return simulation;
    if (auto loaded = load_settings(options.settings, *simulation); !loaded) return loaded.error();
    if (auto set = simulation->apply(options.overrides); !set) return set.error();
    return simulation;
}

namespace {

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

void describe(CLI::App& app, Options& options) {
    add_simulation_options(app, options);
    app.add_flag("--headless", options.headless,
                 "No window: simulate --frames, leave pictures and tables in --out");
    app.add_flag("--panels", options.panels, "Draw the panels into headless pictures too")
        ->needs("--headless");
    app.add_option("--frames", options.frames, "Frames of 1/60 s to run (headless default: 120)")
        ->check(CLI::Range(1, 10'000'000));
    app.add_option("--every", options.every, "Headless: a picture of every n-th frame too, beside the last")
        ->check(CLI::Range(1, 10'000'000));
    app.add_option("--turn", options.turn, "Headless: the camera this far round the scene [degrees]")
        ->check(CLI::Range(-360.0, 360.0));
    app.add_option("--out", options.out, "Folder for what a headless run leaves (default: out)")
        ->type_name("DIR");
    const std::map<std::string, SequenceFormat> formats{
        {"obj", SequenceFormat::obj}, {"pc2", SequenceFormat::pc2}, {"usd", SequenceFormat::usd}};
    app.add_option(
           "--export", options.sequence,
           "Headless: leave the cloth of every frame in --out, as OBJ files, one PC2 cache or one USD file")
        ->needs("--headless")
        ->transform(CLI::CheckedTransformer(formats).description("obj, pc2 or usd"));
    app.add_option_function<std::string>(
           "--size",
           [&options](const std::string& text) {
               if (auto error = parse_size(text, options); !error.empty())
                   throw CLI::ValidationError("--size", error);
           },
           "Size of window and pictures [pixels] (default: 1280x800)")
        ->type_name("WxH");
    app.add_option_function<std::string>(
           "--compare", [&options](const std::string& name) { options.compare = find_method(name)->method; },
           "Show the same scene by this method beside it, and how far both are from the true motion")
        ->check(CLI::IsMember(method_names()));
    app.add_option("--record", options.overrides.record,
                   "Write down all that is done to the cloth, for weft_replay")
        ->type_name("FILE");
    app.add_flag("--check-gl", options.check_gl,
                 "Have the OpenGL driver check what is drawn: what it objects to is printed, and the exit "
                 "status is 1");
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
    if (auto exit = parse(app, argc, argv)) return *std::move(exit);
    return options;
}

}  // namespace weft::demo
