#pragma once
// Says on standard error what a long study is at, and how much time it needs yet.

#include <chrono>
#include <optional>
#include <string>

namespace weft::study {

class StudyProgress {
  public:
    /// Costs are in any unit, as long as it is the same one.
    StudyProgress(std::size_t items, double total_cost) : items_(items), cost_left_(total_cost) {}

    void begin(const std::string& what);
    /// Ends what was begun. What was not measured, since it was there already, says nothing about time.
    void end(double cost, bool measured = true);
    /// Passes over an item in silence.
    void skip(double cost);
    /// For what is neither ended nor passed over, as fast as what was measured; none before anything was.
    [[nodiscard]] std::optional<double> seconds_left() const;

  private:
    using Clock = std::chrono::steady_clock;
    std::size_t items_, item_ = 0;
    double cost_left_, cost_measured_ = 0, seconds_measured_ = 0;
    Clock::time_point begun_;
};

}  // namespace weft::study
