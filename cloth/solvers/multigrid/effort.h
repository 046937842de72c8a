#pragma once
// How much work one solve of the multilevel method takes.

#include "cloth/solvers/linear/conjugate_gradient.h"
#include "weft/methods.h"

namespace weft {

/// For the same work, one linearisation that is solved further. It puts no energy into springs, however
/// stiff.
[[nodiscard]] Multilevel in_one_pass(const Multilevel& method);

/// Counts what a solve has done and says what it shall do next. Decisions follow from the equation alone,
/// never from time. Work is in linearisations.
class Effort {
  public:
    /// `mass` of the cloth [kg], `gamma` of the equation [s]. `one_pass_will_do`: but for the fabric it is
    /// about linear: no features or bodies touch, of which each linearisation takes up others.
    Effort(const Multilevel& method, double mass, double gamma, bool one_pass_will_do = true);

    [[nodiscard]] bool is_at_start() const { return work_ == 0; }
    /// Whether the pass that has begun finds more energy left than the one before found.
    [[nodiscard]] bool has_grown(double decrement) const { return adapts_ && decrement > decrement_; }
    /// Iterations of the pass that has begun. Far from the solution one is enough before the next
    /// linearisation. 0: the equation is so hard that another pass is to start from where the first one did,
    /// and to be solved as far as the work goes.
    [[nodiscard]] int iterations_for(double decrement);
    /// The most that iterations_for() may say of the next pass.
    [[nodiscard]] int most_iterations() const;
    [[nodiscard]] bool goes_back() const { return course_ == Course::back; }
    /// One pass has gone all the way from the start.
    [[nodiscard]] bool is_whole() const { return course_ == Course::whole; }
    /// Makes that way the last step: the energy had this slope down it where it began [J].
    void look_at_whole_way(double slope);
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
    /// passes after one another; then a way back to the start; then all by one pass.
    enum class Course { passes, back, whole };

    [[nodiscard]] bool affords_pass() const;
    [[nodiscard]] int afforded_iterations(double work) const;

    const Multilevel& method_;
    bool adapts_, one_pass_will_do_, is_hard_ = false;
    Course course_ = Course::passes;
    double allowed_, tolerated_;  // work; energy [J]
    double work_ = 0;
    int passes_ = 0;
    double decrement_ = 0, left_ = 0;  // of the last pass: at its start, and the last that is known [J]
    double slope_ = 0;                 // of the energy down the last direction, where the last step began [J]
    float length_ = 0;                 // of that step
};

}  // namespace weft
