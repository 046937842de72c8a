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

Multilevel in_one_pass(const Multilevel& method) {
    Multilevel one = method;
    one.passes = 1;
    one.iterations = static_cast<int>((usual_work(method) - coarse_operators_work - 1) / iteration_work);
    return one;
}

Effort::Effort(const Multilevel& method, double mass, double gamma, bool one_pass_will_do)
    : method_(method),
      adapts_(method.effort > 1),
      one_pass_will_do_(one_pass_will_do),
      allowed_(static_cast<double>(method.effort) * usual_work(method)) {
    const double velocity = static_cast<double>(method.tolerance) * gamma;
    tolerated_ = mass * velocity * velocity;
}

bool Effort::affords_pass() const {
    return work_ + pass_work <= allowed_;
}

int Effort::afforded_iterations(double work) const {
    constexpr double most = 64;
    return static_cast<int>(std::clamp((allowed_ - work - 1) / iteration_work, 0.0, most));
}

int Effort::most_iterations() const {
    return adapts_ ? std::max(method_.iterations, afforded_iterations(work_)) : method_.iterations;
}

// Each pass sets out from springs that are stretched by what the one before left, so that passes of which
// none is solved far put energy into stiff cloth, and it buzzes for ever. One linearisation that is solved
// far takes energy from it, however stiff it is, but wants some ten iterations.
int Effort::iterations_for(double decrement) {
    constexpr int least = 10;
    constexpr float least_effort = 2;  // with less the passes are as many as were asked for, and end nearer
    const bool is_last = passes_ + 1 >= method_.passes;
    if (goes_back()) {
        course_ = Course::whole;
        return std::max(afforded_iterations(work_), 1);
    }
    if (!is_last) return 1;
    if (!adapts_ || !(decrement > tolerated_)) return method_.iterations;
    is_hard_ = true;
    if (one_pass_will_do_ && passes_ == 0) {
        course_ = Course::whole;
        return std::max(afforded_iterations(coarse_operators_work), method_.iterations);
    }
    if (one_pass_will_do_ && method_.effort >= least_effort &&
        afforded_iterations(work_ + pass_work) >= least) {
        course_ = Course::back;
        return 0;
    }
    return 1;
}

void Effort::look_at_whole_way(double slope) {
    slope_ = slope;
    length_ = 1;
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
    if (course_ != Course::passes) return goes_back();
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
