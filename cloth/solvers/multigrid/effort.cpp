#include "cloth/solvers/multigrid/effort.h"

#include <algorithm>

namespace weft {

namespace {

// Of one linearisation, by measurement.
constexpr double iteration_work = 2, coarse_operators_work = 2.7, pass_work = 1 + iteration_work;

double usual_work(const Multilevel& method) {
    const double before_last = method.passes - 1;
    return coarse_operators_work + before_last * pass_work + 1 + iteration_work * method.iterations;
}

}  // namespace

Effort::Effort(const Multilevel& method, double mass, double gamma)
    : method_(method),
      adapts_(method.effort > 1),
      allowed_(static_cast<double>(method.effort) * usual_work(method)) {
    const double velocity = static_cast<double>(method.tolerance) * gamma;
    tolerated_ = mass * velocity * velocity;
}

bool Effort::affords_pass() const {
    return work_ + pass_work <= allowed_;
}

int Effort::iterations_for(double decrement) {
    if (passes_ + 1 < method_.passes) return 1;
    const bool is_far = adapts_ && decrement > tolerated_;
    is_hard_ = is_hard_ || is_far;
    return is_far ? 1 : method_.iterations;
}

void Effort::add(const CgResult& pass) {
    if (is_at_start()) work_ += coarse_operators_work;
    work_ += 1 + iteration_work * std::max(pass.iterations, 1);
    if (pass.iterations == 0) return;
    ++passes_;
    decrement_ = pass.decrement;
    left_ = slope_ = pass.slope;
    length_ = pass.length;
}

bool Effort::wants_another_pass() const {
    if (passes_ < method_.passes && !adapts_) return true;
    return affords_pass() && (passes_ < method_.passes || (is_hard() && left_ > tolerated_));
}

// By the trapezoid of its slopes the energy has risen along the step where it now rises faster than it fell
// at first. Before another pass less is no harm: Newton's method goes on from there. A secant alone would
// nearly undo a step that was far too long.
float Effort::step_back(double slope, bool a_pass_follows) {
    constexpr double least = 0.1;
    if (!(slope < (a_pass_follows ? -slope_ : 0)) || length_ == 0) return 0;
    is_hard_ = true;
    const double kept = std::max(least, slope_ / (slope_ - slope));
    const float shorter = static_cast<float>(kept) * length_;
    const float back = length_ - shorter;
    length_ = shorter;
    return back;
}

}  // namespace weft
