#include "demo/study/contact/contact_result.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "demo/study/contact/contact_measures.h"
#include "demo/study/contact/contact_run.h"
#include "demo/study/crossings/crossings.h"

namespace weft::study {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

class Judge {
  public:
    explicit Judge(const ContactRun& run) : run_(run), edges_(run) {
        result_.particles = run.particles();
        result_.gap = bound_;
        result_.clean_from = 0;
        result_.deepest = run.colliders().empty() ? none : -std::numeric_limits<double>::infinity();
        look();
    }

    /// Call this after every step, which took `seconds`.
    void count_step(double seconds) {
        times_.push_back(seconds);
        result_.pin_lag = std::max(result_.pin_lag, run_.pin_lag());
        const StepFlags flags = run_.world().report().flags;
        result_.unsolved_steps += has(flags, StepFlags::unsolved) ? 1u : 0u;
        result_.restored_steps += has(flags, StepFlags::state_restored) ? 1u : 0u;
        if (run_.time() > run_.scene().seconds - 1) {
            const double speed = rms_speed(run_);
            speeds_ += speed * speed;
            ++speed_count_;
        }
        if (run_.scene().free_momentum > 0 && run_.time() > run_.scene().free_from) follow_momentum();
    }

    /// Measures the present state.
    void look() {
        const TriangleSoup soup = run_.soup();
        const CrossingCount crossings = count_crossings(soup);
        result_.crossings_final = crossings.all;
        result_.between_final = crossings.between_bodies;
        result_.crossings_peak = std::max(result_.crossings_peak, crossings.all);
        if (crossings.all > 0)
            result_.clean_from = none;
        else if (std::isnan(result_.clean_from))
            result_.clean_from = run_.time();
        result_.gap = crossings.all > 0 ? 0 : least_gap(soup, result_.gap);
        const EdgeStretch::Stretch stretch = edges_.of(run_);
        result_.stretch_worst = std::max(result_.stretch_worst, stretch.most);
        result_.stretch_final = stretch.most;
        result_.stretch_mean = stretch.mean;
        result_.deepest_final = run_.colliders().empty() ? none : deepest_in_colliders(run_);
        result_.deepest = std::max(result_.deepest, result_.deepest_final);
    }

    [[nodiscard]] ContactResult result() {
        const ContactScene& scene = run_.scene();
        result_.rest_speed = scene.rests ? std::sqrt(speeds_ / std::max(speed_count_, 1)) : none;
        if (scene.free_momentum <= 0) result_.momentum_drift = none;
        const std::vector<double> heights = layer_heights(run_);
        result_.layers = heights.size();
        result_.layers_in_order = layers_in_order(heights);
        const auto middle = times_.begin() + static_cast<std::ptrdiff_t>(times_.size() / 2);
        std::nth_element(times_.begin(), middle, times_.end());
        result_.median_step = *middle;
        return result_;
    }

  private:
    void follow_momentum() {
        const Eigen::Vector3d now = momentum(run_);
        if (!follows_) start_ = now;
        follows_ = true;
        result_.momentum_drift =
            std::max(result_.momentum_drift, (now - start_).norm() / run_.scene().free_momentum);
    }

    static constexpr double bound_ = 0.1;  // [m]; a larger gap says nothing
    const ContactRun& run_;
    EdgeStretch edges_;
    ContactResult result_;
    std::vector<double> times_;
    double speeds_ = 0;
    int speed_count_ = 0;
    bool follows_ = false;
    Eigen::Vector3d start_;
};

}  // namespace

ContactResult measure_contact(const ContactScene& scene, SelfCollisionMethod method, int every) {
    ContactRun run(scene, method);
    Judge judge(run);
    for (int frame = 1; !run.over(); ++frame) {
        judge.count_step(run.step());
        if (frame % every == 0 || run.over()) judge.look();
    }
    return judge.result();
}

}  // namespace weft::study
