#pragma once
// How much work one solve of the multilevel method takes.

#include "cloth/solvers/linear/conjugate_gradient.h"
#include "weft/methods.h"

namespace weft {

/// Counts what a solve has done and says what it shall do next. Decisions follow from the equation alone,
/// never from time. Work is in linearisations.
class Effort {
  public:
    /// `mass` of the cloth [kg], `gamma` of the equation [s].
    Effort(const Multilevel& method, double mass, double gamma);

    [[nodiscard]] bool is_at_start() const { return work_ == 0; }
    /// Whether the pass that has begun finds more energy left than the one before found.
    [[nodiscard]] bool has_grown(double decrement) const { return adapts_ && decrement > decrement_; }
    /// Iterations of the pass that has begun. Far from the solution one is enough before the next
    /// linearisation.
    [[nodiscard]] int iterations_for(double decrement);
    void add(const CgResult& pass);
    [[nodiscard]] bool wants_another_pass() const;

    /// The last step ends where the energy has this slope down its direction [J]. If that is uphill (and,
    /// where a pass follows, so much that the energy has risen along the step): how much of the step to take
    /// back, as a factor of the direction, to be about where the energy is least, by the secant of the slopes
    /// at both ends. Else 0.
    [[nodiscard]] float step_back(double slope, bool a_pass_follows);

    [[nodiscard]] bool is_hard() const { return adapts_ && is_hard_; }
    [[nodiscard]] bool is_unsolved() const { return left_ > tolerated_; }

  private:
    [[nodiscard]] bool affords_pass() const;

    const Multilevel& method_;
    bool adapts_, is_hard_ = false;
    double allowed_, tolerated_;  // work; energy [J]
    double work_ = 0;
    int passes_ = 0;
    double decrement_ = 0, left_ = 0;  // of the last pass: at its start, and the last that is known [J]
    double slope_ = 0;                 // of the energy down the last direction, where the last step began [J]
    float length_ = 0;                 // of that step
};

}  // namespace weft
