#pragma once
// Percentiles of the stages' times over the frames of several runs, as a tree and as rows of a file.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "weft/weft.h"

namespace weft::demo {

/// The run that the times belong to.
struct Measured {
    std::string scene, method;
    int cloths = 0;
    std::uint32_t particles = 0;  ///< of all cloths
    int threads = 0, substeps = 0, frames = 0;
    std::uint64_t bytes = 0;            ///< of all cloths
    std::uint64_t hash = 0;             ///< of the state after the last frame
    std::uint64_t worst_crossings = 0;  ///< after any frame; 0 unless they are counted
    double processor_ms = 0;            ///< mean of a frame, all threads together
};

class StageTable {
  public:
    /// Adds a frame's times: World::profile() after the frame, with the same stages at every call.
    void add(std::span<const StageTime> stages);
    /// Ends a run of frames: of each percentile the table keeps the least of its runs.
    void end_run();

    /// A line for each stage, the step first, parts indented under their stage: milliseconds, and the median
    /// in nanoseconds per particle.
    [[nodiscard]] std::string text(std::uint32_t particles) const;
    /// Writes the same as rows of a CSV file, each with the data of `measured`.
    [[nodiscard]] Result<void> write_csv(const std::filesystem::path& file, const Measured& measured) const;

  private:
    struct Stage {
        std::string name;
        int depth;
        std::vector<float> times;  // of the present run [ms]
        float p50, p95, p99, max;  // least of the runs that have ended [ms]
    };
    [[nodiscard]] std::vector<const Stage*> step_first() const;

    std::vector<Stage> stages_;
};

}  // namespace weft::demo
