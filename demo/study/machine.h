#pragma once
// The machine and the commit that figures come from, and the progress of a long study.

#include <chrono>
#include <optional>
#include <string>

#include "demo/study/charts/csv.h"

namespace weft::study {

/// The processor and its hardware threads: "Intel(R) Xeon(R) Platinum 8488C; 2 threads".
[[nodiscard]] std::string machine_name();
/// The commit of the source tree when the program first asks, with "+" where the tree differs; "unknown"
/// outside a repository.
[[nodiscard]] std::string commit_name();

/// The line that every picture of a table has at its foot: the command, and the commits and machines of its
/// rows.
[[nodiscard]] std::string origin_of(const CsvTable& table, const std::string& command);

/// Reports the progress of a long study and the time left on standard error.
class StudyProgress {
  public:
    /// Costs may have any unit, the same in all calls.
    StudyProgress(std::size_t items, double total_cost) : items_(items), cost_left_(total_cost) {}

    void begin(const std::string& what);
    /// Ends the item that was begun. Items that were not measured do not count for the time left.
    void end(double cost, bool measured = true);
    /// Skips an item without a message.
    void skip(double cost);
    /// Time for the remaining cost at the speed measured so far; none before the first measurement.
    [[nodiscard]] std::optional<double> seconds_left() const;

  private:
    using Clock = std::chrono::steady_clock;
    std::size_t items_, item_ = 0;
    double cost_left_, cost_measured_ = 0, seconds_measured_ = 0;
    Clock::time_point begun_;
};

}  // namespace weft::study
