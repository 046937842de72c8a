// weft_demo: cloth in the wind, in a window or headless.

#include <cstdio>
#include <variant>

#include "demo/headless/headless.h"
#include "demo/options/options.h"
#include "demo/scene_simulation.h"
#include "demo/window/app.h"

namespace {

using namespace weft::demo;

int refuse(const weft::Error& error) {
    std::fprintf(stderr, "weft_demo: %s\n", error.message.c_str());
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    const auto parsed = parse_options(argc, argv);
    if (const auto* exit = std::get_if<EarlyExit>(&parsed)) {
        std::fputs(exit->text.c_str(), exit->status == 0 ? stdout : stderr);
        return ended("weft_demo", exit->status);
    }
    const auto& options = std::get<Options>(parsed);
    if (options.list) {
        std::fputs(scene_list().c_str(), stdout);
        return ended("weft_demo", 0);
    }

    auto simulation = start_simulation(options);
    if (!simulation) return refuse(simulation.error());
    return ended("weft_demo", options.headless ? run_headless(options, *simulation)
                                               : run_app(options, std::move(*simulation)));
}
