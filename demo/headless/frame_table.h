#pragma once
// Times and counts of every frame of a run, and the progress of the run on standard error.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "weft/weft.h"

namespace weft::demo {

class FrameTable {
  public:
    /// Adds a row. `stages`: World::profile() after the step; the same stages at every call, the whole step
    /// last.
    void add(std::span<const StageTime> stages, const StepReport& report);

    /// One row per frame: its number, the milliseconds of each stage and in total, particles and contacts.
    [[nodiscard]] Result<void> write_csv(const std::filesystem::path& file) const;
    /// p50, p95, p99 and largest of each stage over all frames [ms], as lines of text; parts are
    /// indented under their stage.
    [[nodiscard]] std::string summary() const;

  private:
    [[nodiscard]] std::vector<float> times(std::size_t stage) const;

    struct Row {
        std::uint32_t particles, collider_contacts, self_contacts;
    };
    std::vector<std::string> stages_;
    std::vector<int> depths_;
    std::vector<float> times_;  // stages_.size() per row
    std::vector<Row> rows_;
};

/// The value that a share `p` of the sample does not exceed (nearest rank). Precondition: 0 < p <= 1, not
/// empty.
template <class Number>
[[nodiscard]] Number percentile(std::vector<Number> sample, double p) {
    const double rank = std::ceil(p * static_cast<double>(sample.size()));
    const auto nth = sample.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
    std::ranges::nth_element(sample, nth);
    return *nth;
}

/// On a terminal one line that is rewritten ten times a second; elsewhere a new line every five seconds. Runs
/// shorter than that print nothing.
class Progress {
  public:
    Progress(std::string what, int total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void update(int done);

  private:
    using Clock = std::chrono::steady_clock;
    std::string what_;
    int total_;
    bool terminal_;
    bool line_open_ = false;
    Clock::time_point start_, last_;
};

}  // namespace weft::demo
