#pragma once
// The commands of weft_study and their options.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace weft::study {

/// Options of the commands that measure.
struct StudyOptions {
    std::filesystem::path csv;         ///< rows are appended as they are measured
    bool quick = false;                ///< two minutes in all: smaller sheets, fewer settings
    bool resume = false;               ///< rows that the file already holds are kept and not measured again
    int threads = 0;                   ///< of the simulation; 0: one per core
    std::string only;                  ///< methods whose name contains this; empty: all
    std::filesystem::path cache;       ///< reference states; empty: a folder beside the CSV
    std::filesystem::path garments;    ///< folder of the OBJ files; empty: none are run
    std::vector<std::uint32_t> sizes;  ///< particles per side; empty: the command's own
    bool searches = false;             ///< contact: the broad phases of avoidance instead of scenes
    std::uint32_t particles = 0;       ///< of a scene, about; 0: the scene's own number
    std::vector<std::string> scenes;   ///< empty: all
    /// Sheets of more particles are not compared with the truth: at 256 x 256 it takes 7000 steps a frame.
    std::uint32_t fine_time_limit = 20'000;
};

struct AllOptions {
    std::filesystem::path out = "charts";  ///< folder for tables and charts
    bool quick = false, resume = false;    ///< as in StudyOptions, for each command
};
inline constexpr const char* time_of_all = "some 15 minutes";

struct PlotOptions {
    std::vector<std::filesystem::path> csv;  ///< of any of the commands; told apart by their columns
    std::filesystem::path out = "charts";    ///< folder for scripts, SVG and PNG
};

/// The number of threads meant by an option of 0 or more.
[[nodiscard]] int thread_count(int threads);

// Commands of weft_study. Each returns the program's exit status: 0, or 1 after a message on standard error.

/// Speed against accuracy: every method over its settings, compared with the references.
int run_accuracy(const StudyOptions& options);
/// Where methods fail: stiffness against step, from flat, crumpled and collapsed starts.
int run_stability(const StudyOptions& options);
/// Measured beside known: strips, drapes, pendulums, friction and flags, by every force model.
int run_physics(const StudyOptions& options);
/// Time schemes: energy, nearness to the truth, rest, dependence on the step, and time.
int run_motion(const StudyOptions& options);
/// Crossing triangles: scenes where cloth collides with cloth, by every rung of self-collision.
int run_contact(const StudyOptions& options);
/// With --searches: recall, distance tests and time of the broad phases of avoidance.
int run_searches(const StudyOptions& options);
/// Time and motion error of many cloths: a budget beside one setting for all.
int run_budget(const StudyOptions& options);
/// All tables and charts that demo/charts keeps.
int run_all(const AllOptions& options);
/// Charts of the tables that the other commands wrote.
int run_plot(const PlotOptions& options);

}  // namespace weft::study
