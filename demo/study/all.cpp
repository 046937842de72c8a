// weft_study all: every table and chart that demo/charts keeps.

#include <cstdio>

#include "demo/study/study_options.h"

namespace weft::study {

namespace {

constexpr std::uint32_t contact_particles = 2000;  // of a scene: at their own numbers they take half an hour

}  // namespace

int run_all(const AllOptions& options) {
    std::fprintf(stderr, "weft_study all: %s on two quiet cores; tables and charts in %s\n",
                 options.quick ? "some 3 minutes" : time_of_all, options.out.string().c_str());
    const std::filesystem::path references = options.out / "references";
    if (!options.resume) std::filesystem::remove_all(references);
    PlotOptions plot{{}, options.out};
    const struct {
        const char* name;
        int (*run)(const StudyOptions&);
        int threads;  // times of one thread do not depend on other programs
    } commands[] = {{"accuracy", run_accuracy, 1},
                    {"budget", run_budget, 1},
                    {"stability", run_stability, 0},
                    {"physics", run_physics, 0},
                    {"contact", run_contact, 0}};
    for (const auto& [name, run, threads] : commands) {
        StudyOptions measured;
        measured.csv = options.out / (std::string(name) + ".csv");
        measured.quick = options.quick;
        measured.resume = options.resume;
        measured.threads = threads;
        measured.particles = options.quick ? 0 : contact_particles;
        if (run(measured) != 0) return 1;
        plot.csv.push_back(measured.csv);
    }
    std::filesystem::remove_all(references);
    return run_plot(plot);
}

}  // namespace weft::study
