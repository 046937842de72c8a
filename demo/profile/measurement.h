#pragma once
// The options of weft_profile, the processor's counters, the table of stages, and the run that fills it.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "demo/options/options.h"
#include "weft/weft.h"

namespace weft::demo {

class HardwareCounters {
  public:
    struct Counts {
        std::uint64_t cycles = 0, instructions = 0, cache_misses = 0;
        friend Counts operator-(const Counts& a, const Counts& b) {
            return {a.cycles - b.cycles, a.instructions - b.instructions, a.cache_misses - b.cache_misses};
        }
        Counts& operator+=(const Counts& b) {
            cycles += b.cycles;
            instructions += b.instructions;
            cache_misses += b.cache_misses;
            return *this;
        }
    };

    /// Counts the calling thread and the threads that it starts later.
    HardwareCounters();
    ~HardwareCounters();
    HardwareCounters(const HardwareCounters&) = delete;
    HardwareCounters& operator=(const HardwareCounters&) = delete;

    /// Counts since construction, in user mode. Empty where the kernel or the machine offers no counters.
    [[nodiscard]] std::optional<Counts> read() const;

  private:
    std::array<int, 3> files_;
};

// Percentiles of the stages' times over the frames of several runs, as a tree and as rows of a file.

/// The run that the times belong to.
struct Measured {
    std::string scene, method;
    int cloths = 0;
    std::uint32_t particles = 0;  ///< most that a frame stepped
    int threads = 0, substeps = 0, frames = 0;
    std::uint64_t bytes = 0;            ///< of all cloths
    std::uint64_t hash = 0;             ///< of the state after the last frame
    std::uint64_t worst_crossings = 0;  ///< after any frame; 0 unless they are counted
    double processor_ms = 0;            ///< mean of a frame, all threads together
    int asleep = 0;                     ///< frames in which all cloth slept; they are not in the table
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

// Runs a scene and measures its steps.

/// The command line of weft_profile.
struct ProfileOptions : SimulationOptions {
    int cloths = 1;               ///< the scene's own and copies of its first
    int warm_up = 30;             ///< frames before the measured ones
    int frames = 300;             ///< measured frames
    bool crossings = false;       ///< count those after each measured frame
    int repeat = 1;               ///< runs; of each figure the least is shown, since noise only adds
    std::filesystem::path csv;    ///< empty: none is written
    std::filesystem::path trace;  ///< empty: none is kept
};

[[nodiscard]] std::variant<ProfileOptions, EarlyExit> parse_profile_options(int argc,
                                                                            const char* const* argv);

/// Builds the scene, with copies of its first cloth up to the options' number of cloths. A copy has the same
/// mesh, settings and pins; its pins do not move. Error: the scene cannot be built.
[[nodiscard]] Result<Simulation> build_simulation(const ProfileOptions& options);

/// Runs the warm-up, then the frames. Adds their times to `table` and, where available, their counts to
/// `counts`. The counters must be older than the first simulation, since oneTBB keeps its threads.
[[nodiscard]] Result<Measured> measure(const ProfileOptions& options, const HardwareCounters& counters,
                                       StageTable& table, std::optional<HardwareCounters::Counts>& counts);

/// Runs some frames and writes their trace. Error: the file cannot be written.
[[nodiscard]] Result<void> trace(const ProfileOptions& options);

}  // namespace weft::demo
