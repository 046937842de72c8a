// weft_study budget: times and motion error under a budget, beside one setting for all of equal cost.

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "demo/study/budget/budget_chart.h"
#include "demo/study/budget/crowd.h"
#include "demo/study/charts/csv.h"
#include "demo/study/commands.h"
#include "demo/study/machine.h"
#include "demo/study/run.h"

namespace weft::study {

namespace {

const std::vector<std::string> columns{"machine", "commit",     "kind",     "name",
                                       "mean_ms", "p50_ms",     "p99_ms",   "chosen_p99_ms",
                                       "budget",  "error_mrad", "off_mrad", "changes_per_s"};

struct Candidate {
    std::string kind, name;
    CrowdSettings settings;
};

std::vector<Candidate> fixed_candidates() {
    std::vector<Candidate> all;
    const auto fixed = [&](const std::string& name, const Method& method) {
        all.push_back({"fixed", name, {.method = method}});
    };
    fixed("3 passes", Multilevel{});
    fixed("1 pass", Multilevel{.passes = 1});
    fixed("Jacobi of 15", Jacobi{});
    fixed("Jacobi of 5", Jacobi{.iterations = 5});
    all.push_back({"fixed", "3 passes in 2 steps", {.rung = 2}});
    return all;
}

using Positions3 = std::vector<Vec3>;

/// Times of steps if equal work took equal time: the effect of the budget's choices alone, without the
/// machine's noise.
class ChosenWork {
  public:
    void add(const Crowd& crowd, double time) {
        Step& step = steps_.emplace_back();
        for (std::size_t i = 0; i < crowd.size(); ++i) {
            const Cloth& cloth = crowd.cloth(i);
            const std::size_t kind = kind_of(cloth);
            ++step[kind];
            ++counts_[kind];
            times_[kind] += static_cast<double>(cloth.nanoseconds);
            of_cloths_ += static_cast<double>(cloth.nanoseconds);
        }
        of_steps_ += time;
    }
    [[nodiscard]] std::vector<double> times() const {
        std::vector<double> all;
        for (const Step& step : steps_) {
            double sum = 0;
            for (std::size_t k = 0; k < kinds; ++k)
                if (step[k] > 0) sum += step[k] * times_[k] / counts_[k];
            all.push_back(sum * of_steps_ / of_cloths_);
        }
        return all;
    }

  private:
    static constexpr std::size_t kinds = rung_count + 1;
    using Step = std::array<double, kinds>;
    /// Kind of a cloth's work: a step of its own on each rung; the last kind moves on towards its last step's
    /// end.
    static std::size_t kind_of(const Cloth& cloth) {
        if (!cloth.state.detail) return 0;
        const DetailState& detail = *cloth.state.detail;
        return detail.left + 1 < detail.rate ? rung_count : detail.rung;
    }

    std::vector<Step> steps_;
    Step counts_{}, times_{};
    double of_cloths_ = 0, of_steps_ = 0;
};

class BudgetStudy {
  public:
    explicit BudgetStudy(const StudyOptions& options)
        : steps_(options.quick ? 240 : 960), table_(options.csv, columns, options.resume) {
        std::fputs("the truth, and the cloth as it is set\n", stderr);
        truth_ = motion_of({.substeps = 8});
        as_set_ = motion_of({});
    }

    /// Budgets are shares of the time that the cloth takes as it is set, on any machine.
    void run() {
        double as_set = 0;
        for (const Candidate& candidate : fixed_candidates()) {
            const double mean = measure(candidate);
            if (as_set == 0) as_set = mean;
        }
        for (const int percent : {60, 70, 80, 90}) {
            const auto budget = static_cast<float>(0.01 * percent * as_set);
            measure({"budget", std::to_string(percent) + " %", {.budget = budget}});
        }
    }

  private:
    /// The first quarter does not count: costs have to become known.
    [[nodiscard]] bool is_counted(int step) const { return step >= steps_ / 4; }
    [[nodiscard]] bool is_compared(int step) const { return is_counted(step) && step % 3 == 0; }

    [[nodiscard]] std::vector<Positions3> motion_of(const CrowdSettings& settings) const {
        std::vector<Positions3> motion;
        Crowd crowd(settings);
        for (int s = 0; s < steps_; ++s) {
            crowd.step();
            if (is_compared(s)) motion.push_back(positions_of(crowd));
        }
        return motion;
    }

    static Positions3 positions_of(const Crowd& crowd) {
        Positions3 all;
        for (std::size_t i = 0; i < crowd.size(); ++i)
            for (const Vec4& p : crowd.cloth(i).state.positions.span()) all.push_back({p.x, p.y, p.z});
        return all;
    }

    /// Sum of squared view angles between actual and true positions of seen cloths' particles [rad^2], and
    /// the particles' number.
    static std::pair<double, double> error_of(const Crowd& crowd, const Positions3& truth) {
        double sum = 0, number = 0;
        auto should = truth.begin();
        for (std::size_t i = 0; i < crowd.size(); ++i) {
            const double distance = static_cast<double>(crowd.distance(i));
            for (const Vec4& p : crowd.cloth(i).state.positions.span()) {
                const Vector3 off = xyz(p) - to_vector(*should++);
                if (!crowd.is_seen(i)) continue;
                sum += static_cast<double>(off.squaredNorm()) / (distance * distance);
                ++number;
            }
        }
        return {sum, number};
    }

    /// Returns the mean time of a step [ms].
    double measure(const Candidate& candidate) {
        Crowd crowd(candidate.settings);
        std::vector<double> times;
        ChosenWork chosen;
        double squares = 0, off = 0, number_of = 0, changes = 0;
        std::size_t compared = 0;
        for (int s = 0; s < steps_; ++s) {
            const double time = crowd.step();
            if (!is_counted(s)) continue;
            times.push_back(time);
            chosen.add(crowd, time);
            changes += static_cast<double>(crowd.simulation().choices.size());
            if (!is_compared(s)) continue;
            const auto [sum, particles] = error_of(crowd, truth_[compared]);
            squares += sum;
            number_of += particles;
            off += error_of(crowd, as_set_[compared++]).first;
        }
        double mean = 0;
        for (const double time : times) mean += time / static_cast<double>(times.size());
        const double p50 = quantile(times, 0.5), p99 = quantile(times, 0.99),
                     chosen_p99 = quantile(chosen.times(), 0.99);
        const double error = 1e3 * std::sqrt(squares / number_of),
                     from_set = 1e3 * std::sqrt(off / number_of);
        std::printf(
            "%-7s %-24s mean %.2f  p50 %.2f  p99 %.2f, chosen %.2f ms  error %.3f, off %.3f mrad  %.1f "
            "changes "
            "a second\n",
            candidate.kind.c_str(), candidate.name.c_str(), mean, p50, p99, chosen_p99, error, from_set,
            60 * changes / static_cast<double>(times.size()));
        std::fflush(stdout);
        table_.replace({{"machine", machine_name()},
                        {"commit", commit_name()},
                        {"kind", candidate.kind},
                        {"name", candidate.name},
                        {"mean_ms", number(mean)},
                        {"p50_ms", number(p50)},
                        {"p99_ms", number(p99)},
                        {"chosen_p99_ms", number(chosen_p99)},
                        {"budget", number(static_cast<double>(candidate.settings.budget))},
                        {"error_mrad", number(error)},
                        {"off_mrad", number(from_set)},
                        {"changes_per_s", number(60 * changes / static_cast<double>(times.size()))}},
                       {"kind", "name"});
        return mean;
    }

    int steps_;
    CsvWriter table_;
    std::vector<Positions3> truth_, as_set_;
};

}  // namespace

int run_budget(const StudyOptions& options) {
    BudgetStudy(options).run();
    return 0;
}

}  // namespace weft::study
