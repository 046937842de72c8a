#pragma once
// Times and counts of every frame of a run.

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
[[nodiscard]] float percentile(std::vector<float> sample, double p);

}  // namespace weft::demo
