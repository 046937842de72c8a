// weft_study motion: time schemes by energy and speed of motion, distance from the truth, time to rest and
// cost.

#include <array>
#include <cstdio>
#include <limits>
#include <map>

#include "demo/headless/frame_table.h"
#include "demo/study/accuracy/motion_measures.h"
#include "demo/study/charts/csv.h"
#include "demo/study/machine.h"
#include "demo/study/reference/states.h"
#include "demo/study/run.h"
#include "demo/study/study_options.h"

namespace weft::study {

namespace {

const std::vector<std::string> motion_columns{
    "machine",           "commit",      "method",       "per_side",
    "truth_side",        "time",        "ms",           "energy_lost",
    "energy_lost_truth", "truth_05_mm", "truth_1_mm",   "own_05_mm",
    "own_1_mm",          "rest_s",      "speed_40_mms", "speed_30",
    "speed_60",          "speed_120",   "speed_240"};
const std::vector<std::string> keys{"method", "per_side", "truth_side"};

/// Backward Euler and BDF2 at some numbers of passes and substeps. Times are relative to the first.
std::vector<MethodPoint> candidates() {
    std::vector<MethodPoint> points;
    const auto add = [&](TimeScheme scheme, int passes, int substeps) {
        const bool second = scheme == TimeScheme::bdf2;
        std::string name = second ? "bdf2-" : "euler-";
        name += std::to_string(passes);
        if (substeps > 1) name += "-s" + std::to_string(substeps);
        const auto configure = [=](ClothSettings& settings) {
            settings.method = Multilevel{.passes = passes};
            settings.time_scheme = scheme;
            settings.substeps = substeps;
        };
        const ClothSettings usual;
        const auto* method = std::get_if<Multilevel>(&usual.method);
        const bool is_default = method != nullptr && method->passes == passes &&
                                resolved(usual.time_scheme, usual.method) == scheme &&
                                usual.substeps == substeps;
        points.push_back({name, name, "", configure, {}, is_default});
    };
    constexpr TimeScheme euler = TimeScheme::backward_euler, bdf2 = TimeScheme::bdf2;
    for (const int passes : {3, 1}) add(euler, passes, 1);
    for (const int passes : {1, 2, 3, 4, 6}) add(bdf2, passes, 1);
    for (const int passes : {1, 2, 3}) add(bdf2, passes, 2);
    for (const int passes : {1, 3}) add(bdf2, passes, 4);
    return points;
}

struct Sizes {
    std::uint32_t swing = 65, truth = 128, rest = 33;
    double rest_seconds = 40;
    int rounds = 9;
};

Sizes sizes_of(const StudyOptions& options) {
    Sizes sizes;
    if (options.quick) sizes = {.swing = 17, .truth = 33, .rest = 17, .rest_seconds = 25, .rounds = 3};
    if (!options.sizes.empty()) sizes.truth = options.sizes.front();
    return sizes;
}

constexpr double swing_seconds = 2;
constexpr double at_rest = 1e-3;  // [m/s]
constexpr std::array<int, 4> rates{30, 60, 120, 240};

class Motion {
  public:
    explicit Motion(const StudyOptions& options)
        : threads_(thread_count(options.threads)),
          sizes_(sizes_of(options)),
          hung_(hung_sheet(sizes_.truth, false)),
          swinging_(swinging_sheet(sizes_.swing)),
          table_(options.csv, motion_columns, options.resume) {
        const std::filesystem::path beside = options.csv.parent_path() / "references";
        ReferenceStore store(options.cache.empty() ? beside : options.cache);
        std::fputs("the truth\n", stderr);
        truth_ = store.states(hung_, Reference::fine_time, {30, 60});
        lost_in_truth_ = energy_lost(swinging_, true_swing(swinging_, 60, swing_seconds, threads_));
        std::printf("truth: %.2f of the swing's energy lost in %g s\n", lost_in_truth_, swing_seconds);
    }

    void run(const std::vector<MethodPoint>& points) {
        StudyProgress progress(points.size(), static_cast<double>(points.size()));
        std::printf("%-12s %5s %6s | %5s | truth 0.5, 1 s | own 0.5, 1 s [mm] | rest s, mm/s | swing at %s\n",
                    "method", "time", "ms", "lost", "30, 60, 120, 240 Hz [m/s]");
        for (const MethodPoint& point : points) {
            progress.begin(point.name);
            CsvRow row{{"method", point.name},
                       {"per_side", std::to_string(sizes_.swing)},
                       {"truth_side", std::to_string(sizes_.truth)}};
            const bool is_new = table_.find(row, keys) == nullptr;
            if (is_new) table_.append(measured(points.front(), point, std::move(row)));
            print(*table_.find(key_of(point), keys), point.is_default);
            progress.end(1, is_new);
        }
    }

  private:
    [[nodiscard]] CsvRow key_of(const MethodPoint& point) const {
        return {{"method", point.name},
                {"per_side", std::to_string(sizes_.swing)},
                {"truth_side", std::to_string(sizes_.truth)}};
    }

    CsvRow measured(const MethodPoint& first, const MethodPoint& point, CsvRow row) {
        row["machine"] = machine_name();
        row["commit"] = commit_name();
        const Times times = times_of(first, point);
        row["time"] = number(times.ratio);
        row["ms"] = number(times.milliseconds);
        row["energy_lost_truth"] = number(lost_in_truth_);
        add_swings(point, row);
        add_distances(point, row);
        StudyScene hung = hung_sheet(sizes_.rest, false);
        hung.world.wind.air_density = Wind{}.air_density;  // still air ends motion
        const std::vector<double> speeds = peak_speeds(hung, point, sizes_.rest_seconds, threads_);
        row["rest_s"] = number(time_to_rest(speeds, static_cast<double>(hung.frame), at_rest));
        row["speed_40_mms"] = number(1000 * speeds.back());
        return row;
    }

    struct Times {
        double ratio, milliseconds;  ///< of a frame; ratio: over the first point's
    };
    /// Medians over frames that alternate with the first point's, so that a slow moment falls on both.
    [[nodiscard]] Times times_of(const MethodPoint& first, const MethodPoint& point) const {
        constexpr int frames = 30;
        std::vector<double> ratios, milliseconds;
        Run a(hung_, first, threads_), b(hung_, point, threads_);
        for (int round = 0; round < sizes_.rounds; ++round) {
            a.restart(hung_);
            b.restart(hung_);
            for (int frame = 0; frame < frames; ++frame) {
                const double usual = a.step();
                milliseconds.push_back(b.step());
                ratios.push_back(milliseconds.back() / usual);
            }
        }
        return {demo::percentile(ratios, 0.5), demo::percentile(milliseconds, 0.5)};
    }

    void add_swings(const MethodPoint& point, CsvRow& row) const {
        for (const int hz : rates) {
            const Swing seen = swing(swinging_, point, hz, swing_seconds, threads_);
            row["speed_" + std::to_string(hz)] = number(seen.speed);
            if (hz == 60) row["energy_lost"] = number(energy_lost(swinging_, seen));
        }
    }

    void add_distances(const MethodPoint& point, CsvRow& row) {
        const ClothSettings settings = point.applied_to({});
        const States states = states_of(point);
        const States& own = converged(settings.time_scheme, settings.substeps);
        for (const auto& [frame, name] : {std::pair(30, "05_mm"), {60, "1_mm"}}) {
            const Positions& there = states.at(frame);
            row[std::string("truth_") + name] = number(1000 * rms_distance(there, truth_.at(frame)));
            row[std::string("own_") + name] = number(1000 * rms_distance(there, own.at(frame)));
        }
    }

    [[nodiscard]] States states_of(const MethodPoint& point) const {
        Run run(hung_, point, threads_);
        States states;
        for (int frame = 1; frame <= 60; ++frame) {
            run.step();
            if (frame % 30 == 0) states[frame] = positions_of(run.cloth());
        }
        return states;
    }

    /// The states by 48 passes, which on this sheet are converged to within a millimetre.
    const States& converged(TimeScheme scheme, int substeps) {
        States& states = converged_[{scheme, substeps}];
        if (!states.empty()) return states;
        MethodPoint point;
        point.configure = [=](ClothSettings& settings) {
            settings.method = Multilevel{.passes = 48};
            settings.time_scheme = scheme;
            settings.substeps = substeps;
        };
        return states = states_of(point);
    }

    static void print(const CsvRow& row, bool is_default) {
        const auto value = [&](const char* name) {
            return parse_number(row.at(name)).value_or(std::numeric_limits<double>::infinity());
        };
        std::printf(
            "%-12s %5.2f %6.3f | %5.2f | %6.1f %6.1f  | %6.1f %6.1f      | %5.1f %7.2f | %.2f %.2f %.2f "
            "%.2f%s\n",
            row.at("method").c_str(), value("time"), value("ms"), value("energy_lost"), value("truth_05_mm"),
            value("truth_1_mm"), value("own_05_mm"), value("own_1_mm"), value("rest_s"),
            value("speed_40_mms"), value("speed_30"), value("speed_60"), value("speed_120"),
            value("speed_240"), is_default ? "  the default" : "");
        std::fflush(stdout);
    }

    int threads_;
    Sizes sizes_;
    StudyScene hung_, swinging_;
    CsvWriter table_;
    States truth_;
    double lost_in_truth_ = 0;
    std::map<std::pair<TimeScheme, int>, States> converged_;
};

}  // namespace

int run_motion(const StudyOptions& options) {
    const std::vector<MethodPoint> all = candidates();
    std::vector<MethodPoint> points = only_named(all, options.only);
    if (points.empty()) {
        std::fprintf(stderr, "weft_study: no method's name contains %s\n", options.only.c_str());
        return 1;
    }
    // Times are relative to the first candidate's.
    if (points.front().name != all.front().name) points.insert(points.begin(), all.front());
    Motion(options).run(points);
    return 0;
}

}  // namespace weft::study
