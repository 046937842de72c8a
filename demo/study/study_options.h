#pragma once
// Options of the commands of weft_study.

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

}  // namespace weft::study
