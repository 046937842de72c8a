// Where methods fail: a map of stiffness against step for every method and start.

#include <algorithm>
#include <cmath>
#include <map>

#include "demo/study/charts/csv.h"
#include "demo/study/machine.h"
#include "demo/study/stability/stability_causes.h"
#include "demo/study/stability/stability_cell.h"
#include "demo/study/stability/stability_points.h"
#include "demo/study/study_options.h"

namespace weft::study {

namespace {

const std::vector<std::string> stability_columns{
    "machine",  "commit",        "method",      "label",       "default", "family",
    "per_side", "seconds",       "start",       "stiffness",   "hz",      "verdict",
    "broken",   "lasted_s",      "energy_rise", "energy_gain", "stretch", "hang_stretch",
    "height_m", "hang_height_m", "h_s",         "h_omega",     "left"};
const std::vector<std::string> keys{"method", "per_side", "start", "stiffness", "hz"};

struct Axes {
    std::vector<double> stiffness{1, 10, 100, 1000, 10000};
    std::vector<int> hz{240, 120, 60, 30, 15};
};

/// All maps of one run of the program.
class Maps {
  public:
    explicit Maps(const StudyOptions& options)
        : sheet_(sheet_of(options)),
          table_(options.csv, stability_columns, options.resume),
          parallel_(thread_count(options.threads)),
          machine_(machine_name()),
          commit_(commit_name()),
          frequency_(stiffest_frequency(stability_scene(sheet_, Start::flat, 1))) {
        if (options.quick) axes_ = {{1, 100, 10000}, {240, 60, 15}};
    }

    void run(const std::vector<StabilityPoint>& points) {
        StudyProgress progress(points.size() * std::size(starts), total_cost(points));
        for (const StabilityPoint& point : points) {
            for (const Start start : starts) {
                progress.begin(point.method.label + ", " + name_of(start));
                const bool measured = run_map(point, start);
                progress.end(cost(point), measured);
            }
        }
    }

  private:
    struct Cell {
        double stiffness;
        int hz;
        RunMeasures measures{};
    };

    static StabilitySheet sheet_of(const StudyOptions& options) {
        StabilitySheet sheet;
        if (options.quick) sheet.per_side = 12;
        if (!options.sizes.empty()) sheet.per_side = options.sizes.front();
        return sheet;
    }

    /// Estimated cost in substeps of an explicit method.
    static double cost(const StabilityPoint& point) {
        const bool solves = point.family == Family::newton || point.family == Family::one_linearisation;
        const double linear_system = point.method.make_solver ? 150 : 20;
        return solves ? linear_system : 2 + point.method.applied_to({}).substeps;
    }
    static double total_cost(const std::vector<StabilityPoint>& points) {
        double sum = 0;
        for (const StabilityPoint& point : points)
            sum += cost(point) * static_cast<double>(std::size(starts));
        return sum;
    }

    /// Measures the cells that the table lacks. False if it held all.
    bool run_map(const StabilityPoint& point, Start start) {
        std::vector<Cell> cells = cells_left(point, start);
        for (const Cell& cell : cells) hang_at(cell.stiffness);
        parallel_.blocks(static_cast<std::uint32_t>(cells.size()), [&](std::uint32_t i) {
            Cell& cell = cells[i];
            cell.measures = measure_cell(sheet_, point.method, start, cell.stiffness, 1.0 / cell.hz,
                                         hangs_.at(cell.stiffness));
        });
        for (const Cell& cell : cells) table_.append(row_of(point, start, cell));
        return !cells.empty();
    }

    /// The cells that the table lacks. Costly ones (short steps) come first, so that threads end together.
    std::vector<Cell> cells_left(const StabilityPoint& point, Start start) const {
        std::vector<Cell> cells;
        for (const int hz : axes_.hz) {
            for (const double stiffness : axes_.stiffness) {
                const CsvRow row = key_of(point, start, stiffness, hz);
                if (table_.find(row, keys) == nullptr) cells.push_back({stiffness, hz});
            }
        }
        return cells;
    }

    void hang_at(double stiffness) {
        if (!hangs_.contains(stiffness)) hangs_[stiffness] = still_hang(sheet_, stiffness);
    }

    /// Largest eigenvalue of D^-1 W, for steps of the whole frame.
    static double largest_eigenvalue_at(const StabilitySheet& sheet, const Cell& cell) {
        StudyScene scene = stability_scene(sheet, Start::flat, cell.stiffness);
        scene.frame = static_cast<float>(1.0 / cell.hz);
        return largest_relaxed(scene);
    }

    [[nodiscard]] CsvRow key_of(const StabilityPoint& point, Start start, double stiffness, int hz) const {
        return {{"method", point.method.name},
                {"per_side", std::to_string(sheet_.per_side)},
                {"start", name_of(start)},
                {"stiffness", number(stiffness)},
                {"hz", number(hz)}};
    }

    CsvRow row_of(const StabilityPoint& point, Start start, const Cell& cell) const {
        const RunMeasures& run = cell.measures;
        const Judgement judgement = judge(run, tolerance_of(start));
        const double h = 1.0 / cell.hz / point.method.applied_to({}).substeps;
        CsvRow row = key_of(point, start, cell.stiffness, cell.hz);
        row["machine"] = machine_;
        row["commit"] = commit_;
        row["label"] = point.method.label;
        row["default"] = point.method.is_default ? "yes" : "";
        row["family"] = name_of(point.family);
        row["seconds"] = number(sheet_.seconds);
        row["verdict"] = word(judgement.verdict);
        row["broken"] = judgement.broken();
        row["lasted_s"] = number(run.lasted);
        row["energy_rise"] = number(run.energy_rise());
        row["energy_gain"] = number(run.energy_gain());
        row["stretch"] = number(run.stretch);
        row["hang_stretch"] = number(run.hang_stretch);
        row["height_m"] = number(run.height);
        row["hang_height_m"] = number(run.hang_height);
        row["h_s"] = number(h);
        row["h_omega"] = number(h * frequency_ * std::sqrt(cell.stiffness));
        if (point.left_of) row["left"] = number(point.left_of(largest_eigenvalue_at(sheet_, cell)));
        return row;
    }

    StabilitySheet sheet_;
    Axes axes_;
    CsvWriter table_;
    Parallel parallel_;
    std::string machine_, commit_;
    double frequency_;  // of the stiffest mode at stiffness 1
    std::map<double, Hang> hangs_;
};

}  // namespace

int run_stability(const StudyOptions& options) {
    std::vector<StabilityPoint> points = stability_points();
    std::erase_if(points, [&](const StabilityPoint& point) {
        return point.method.name.find(options.only) == std::string::npos;
    });
    Maps(options).run(points);
    return 0;
}

}  // namespace weft::study
