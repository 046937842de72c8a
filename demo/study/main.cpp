// weft_study: the cost of each method, its error, and the cases in which it fails.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "demo/study/study_options.h"

namespace {

using namespace weft::study;

void describe_table(CLI::App& command, StudyOptions& options) {
    command.add_option("--csv", options.csv, "File for the rows")->required()->type_name("FILE");
    command.add_flag("--quick", options.quick, "Two minutes in all: smaller sheets, fewer settings");
    command.add_flag("--resume", options.resume, "Keep the file's rows and measure only those missing");
}

void describe_measuring(CLI::App& command, StudyOptions& options) {
    describe_table(command, options);
    command.add_option("--threads", options.threads, "Threads of the simulation (default: one per core)")
        ->check(CLI::Range(1, 256));
    command.add_option("--only", options.only, "Methods whose name contains this")->type_name("TEXT");
    command.add_option("--sizes", options.sizes, "Particles per side of the sheets")
        ->delimiter(',')
        ->check(CLI::Range(4u, 1024u))
        ->type_name("N,N...");
}

void describe_accuracy(CLI::App& command, StudyOptions& options) {
    describe_measuring(command, options);
    command
        .add_option("--scenes", options.scenes,
                    "hanging, wind, tshirt, dress (default: the first three, with --quick two)")
        ->delimiter(',')
        ->check(CLI::IsMember({"hanging", "wind", "tshirt", "dress"}))
        ->type_name("NAME,NAME...");
    command.add_option("--cache", options.cache, "Folder of reference states (default: beside the CSV)")
        ->type_name("DIR");
    command.add_option(
        "--fine-time-up-to", options.fine_time_limit,
        "Particles up to which the true motion is made (default: 20000; 65536 take an hour a scene)");
    command
        .add_option("--garments", options.garments,
                    "Folder that holds tshirt-iso.obj and dress-victor-iso-draped.obj (default: garments in "
                    "the folder that WEFT_DATA names)")
        ->check(CLI::ExistingDirectory)
        ->type_name("DIR");
}

void describe_physics(CLI::App& command, StudyOptions& options) {
    describe_table(command, options);
    command
        .add_option("--only", options.only,
                    "Tests whose name and force model, as in \"swing, springs, mesh\", contain this")
        ->type_name("TEXT");
}

void describe_contact(CLI::App& command, StudyOptions& options) {
    describe_table(command, options);
    command.add_option("--threads", options.threads, "Threads of --searches; a scene has one (default: 1)")
        ->check(CLI::Range(1, 256));
    command
        .add_option("--only", options.only,
                    "Scenes whose name and rung, as in \"stack 2, off\", contain this")
        ->type_name("TEXT");
    command.add_flag(
        "--searches", options.searches,
        "Instead of scenes, the searches of avoidance (exact, shifted grids, sorted sweep): what each "
        "finds, tests and takes on one thread");
    command.add_option("--particles", options.particles, "Particles of a scene, about (default: its own)")
        ->check(CLI::Range(64u, 1u << 20));
}

void describe_all(CLI::App& command, AllOptions& options) {
    command.add_option("--out", options.out, "Folder for tables and charts (default: charts)")
        ->type_name("DIR");
    command.add_flag("--quick", options.quick, "Some 3 minutes: smaller sheets, fewer settings");
    command.add_flag("--resume", options.resume, "Keep the rows of the folder's tables");
}

void describe_plot(CLI::App& command, PlotOptions& options) {
    command.add_option("--csv", options.csv, "Files that the other commands wrote")
        ->required()
        ->check(CLI::ExistingFile)
        ->type_name("FILE...");
    command.add_option("--out", options.out, "Folder for the charts (default: charts)")->type_name("DIR");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Weft: what each method costs, how wrong it is and where it fails.", "weft_study");
    app.require_subcommand(1);
    StudyOptions accuracy, stability, physics, motion, contact, budget;
    AllOptions all;
    PlotOptions plot;
    CLI::App* const accuracy_command = app.add_subcommand("accuracy", "Speed against accuracy, as CSV");
    CLI::App* const stability_command =
        app.add_subcommand("stability", "Stiffness against step from hard starts, as CSV");
    CLI::App* const physics_command =
        app.add_subcommand("physics", "Measured beside known, as CSV and as a table");
    CLI::App* const motion_command =
        app.add_subcommand("motion", "Time schemes: energy, truth, rest, steps and time, as a table and CSV");
    CLI::App* const contact_command =
        app.add_subcommand("contact", "What passes through what where cloth meets itself, as CSV and table");
    CLI::App* const budget_command =
        app.add_subcommand("budget", "Fifty cloths within a time a step, beside one setting for all, as CSV");
    CLI::App* const plot_command = app.add_subcommand("plot", "Charts of such files, as SVG and PNG");
    CLI::App* const all_command = app.add_subcommand(
        "all", std::string("accuracy, budget, stability, physics and contact, and their charts: ") +
                   time_of_all + " on two quiet cores");
    describe_accuracy(*accuracy_command, accuracy);
    describe_measuring(*stability_command, stability);
    describe_physics(*physics_command, physics);
    describe_measuring(*motion_command, motion);
    describe_contact(*contact_command, contact);
    describe_table(*budget_command, budget);
    describe_plot(*plot_command, plot);
    describe_all(*all_command, all);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::fputs(app.help().c_str(), stdout);
        return 0;
    } catch (const CLI::ParseError& error) {
        std::fprintf(stderr, "weft_study: %s (--help lists the options)\n", error.what());
        return 2;
    }
    try {
        if (accuracy_command->parsed()) return run_accuracy(accuracy);
        if (stability_command->parsed()) return run_stability(stability);
        if (physics_command->parsed()) return run_physics(physics);
        if (motion_command->parsed()) return run_motion(motion);
        if (contact_command->parsed()) return run_contact(contact);
        if (budget_command->parsed()) return run_budget(budget);
        if (all_command->parsed()) return run_all(all);
        return run_plot(plot);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "weft_study: %s\n", error.what());
        return 1;
    }
}
