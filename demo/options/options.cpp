#include "demo/options/options.h"

#include <array>
#include <CLI/CLI.hpp>
#include <map>

namespace weft::demo {
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
