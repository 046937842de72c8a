// weft_study budget: times and motion error under a budget, beside one setting for all of equal cost.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cloth/simulation/simulation.h"
#include "demo/headless/frame_table.h"
#include "demo/study/charts/charts.h"
#include "demo/study/charts/csv.h"
#include "demo/study/machine.h"
#include "demo/study/run.h"
#include "demo/study/study_options.h"

namespace weft::study {

namespace {

/// How a crowd is stepped.
struct CrowdSettings {
    Method method{};
    int substeps = 1;
    float budget = 0;        ///< [ms]
    std::uint32_t rung = 0;  ///< of the budget's ladder, the same for all cloths; 0: the budget chooses
};

class Crowd {
  public:
    explicit Crowd(const CrowdSettings& settings);
    /// Takes one step and returns its processor time [ms].
    double step();
    /// True if the camera sees the cloth; and the distance between them [m].
    [[nodiscard]] bool is_seen(std::size_t cloth) const;
    [[nodiscard]] float distance(std::size_t cloth) const { return distances_[cloth]; }
    [[nodiscard]] std::size_t size() const { return cloths_.size(); }
    [[nodiscard]] const Cloth& cloth(std::size_t i) const { return *cloths_[i]; }
    [[nodiscard]] const Simulation& simulation() const { return simulation_; }

  private:
    Simulation simulation_;
    std::vector<Cloth*> cloths_;
    std::vector<float> angles_, distances_;
    int steps_ = 0;
};

constexpr std::size_t count = 50;
constexpr std::uint32_t side = 17;
constexpr float frame = 1.0f / 60;
constexpr float turn = 8;        // time of the camera's full turn [s]
constexpr float half_sight = 1;  // half the camera's angle of view [rad]

std::int64_t processor_nanoseconds() noexcept {
    return static_cast<std::int64_t>(std::clock()) * (1'000'000'000 / CLOCKS_PER_SEC);
}

WorldSettings world_of(const CrowdSettings& settings) {
    WorldSettings world;
    world.wind.velocity = {0.5f, 0, 3};
    world.wind.gust = 0.5f;
    world.threads = 1;
    world.budget = settings.rung > 0 ? 1000.0f : settings.budget;
    return world;
}

Mesh curtain(float x, float z) {
    return make_sheet({.rows = side, .columns = side, .origin = {x, 2, z}, .u = {1, 0, 0}, .v = {0, -1, 0}})
        .value();
}

Crowd::Crowd(const CrowdSettings& settings) : simulation_(world_of(settings)) {
    simulation_.clock = processor_nanoseconds;
    simulation_.has_given_choices = settings.rung > 0;
    ClothSettings of_cloth;
    of_cloth.method = settings.method;
    of_cloth.substeps = settings.substeps;
    for (std::size_t i = 0; i < count; ++i) {
        // Curtains stand all round, at distances that grow quadratically from 2 towards 60 m.
        const float part = static_cast<float>(i) / count;
        distances_.push_back(2 + 58 * part * part);
        angles_.push_back(std::fmod(2.4f * static_cast<float>(i), 2 * std::numbers::pi_v<float>));
        const Mesh mesh = curtain(distances_[i] * std::cos(angles_[i]), distances_[i] * std::sin(angles_[i]));
        auto cloth = std::make_unique<Cloth>(cook(mesh).value(), of_cloth);
        std::vector<std::uint32_t> upper_row;
        for (std::uint32_t k = 0; k < side; ++k) upper_row.push_back(cloth->model.vertex_to_particle[k]);
        cloth->pin(upper_row);
        simulation_.prepare(*cloth);
        if (settings.rung > 0) cloth->state.detail->rung = settings.rung;
        cloths_.push_back(cloth.get());
        simulation_.add(std::move(cloth));
    }
}

bool Crowd::is_seen(std::size_t cloth) const {
    const float ahead = 2 * std::numbers::pi_v<float> * static_cast<float>(steps_) * frame / turn;
    return std::cos(angles_[cloth] - ahead) > std::cos(half_sight);
}

double Crowd::step() {
    ++steps_;
    for (std::size_t i = 0; i < size(); ++i) {
        cloths_[i]->settings.importance = (is_seen(i) ? 1.0f : 0.02f) / distances_[i];
    }
    const std::int64_t begin = processor_nanoseconds();
    simulation_.step(frame);
    return 1e-6 * static_cast<double>(processor_nanoseconds() - begin);
}

const std::vector<std::string> budget_columns{"machine", "commit",     "kind",     "name",
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
        : steps_(options.quick ? 240 : 960), table_(options.csv, budget_columns, options.resume) {
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
        const double p50 = demo::percentile(times, 0.5), p99 = demo::percentile(times, 0.99),
                     chosen_p99 = demo::percentile(chosen.times(), 0.99);
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
