// weft_study accuracy: every method over its settings against the references.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numeric>

#include "demo/study/accuracy/accuracy_rows.h"
#include "demo/study/commands.h"
#include "demo/study/study_progress.h"
#include "demo/study/study_scenes.h"

namespace weft::study {

namespace {

/// Estimated cost of a point per particle, in the time of one iteration.
double work_of(const MethodPoint& point) {
    const ClothSettings settings = point.applied_to({});
    const auto iterations = [](const auto& method) {
        if constexpr (requires { method.iterations; })
            return static_cast<double>(method.iterations);
        else if constexpr (requires { method.passes; })
            return static_cast<double>(method.passes);
        else
            return 1.0;
    };
    const double each = point.name == "cholesky" ? 1000 : 5 + std::visit(iterations, settings.method);
    return each * settings.substeps;
}

constexpr double work_of_references = 10'000;

constexpr int rounds = 3;             // of timing all points
constexpr double longest_run = 2000;  // [ms]; points that take longer get no further round

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// A scene and the points that are run on it.
struct Part {
    StudyScene scene;
    std::vector<MethodPoint> points;
    bool is_garment;

    [[nodiscard]] double cost(double work) const {
        return work * static_cast<double>(scene.mesh.positions.size());
    }
};

std::filesystem::path garment_folder(const StudyOptions& options) {
    if (!options.garments.empty()) return options.garments;
    const char* const data = std::getenv("WEFT_DATA");
    return data == nullptr ? std::filesystem::path{} : std::filesystem::path(data) / "garments";
}

bool is_wanted(const StudyOptions& options, const std::string& scene) {
    return options.scenes.empty() || std::ranges::find(options.scenes, scene) != options.scenes.end();
}

std::vector<MethodPoint> points_for(const StudyOptions& options, const StudyScene& scene, bool is_garment) {
    auto points = method_points(options.quick ? Coverage::quick : Coverage::all, scene);
    // Garments are judged by one step, which has no history, and by the energy of springs.
    if (is_garment)
        std::erase_if(points, [](const MethodPoint& p) {
            const ClothSettings settings = p.applied_to({});
            return resolved(settings.time_scheme, settings.method) == TimeScheme::bdf2 ||
                   settings.finite_elements.enabled;
        });
    return only_named(std::move(points), options.only);
}

/// Calls append(scene, is_garment) for the garments that are wanted. A quick run has time for them only if
/// scenes are named.
template <class Append>
void append_garments(const StudyOptions& options, const Append& append) {
    if (options.quick && options.scenes.empty()) return;
    const bool tshirt = is_wanted(options, "tshirt"), dress = is_wanted(options, "dress");
    if (!tshirt && !dress) return;
    const std::filesystem::path folder = garment_folder(options);
    if (folder.empty()) {
        std::fputs(
            "weft_study: garments are left out, since neither --garments nor WEFT_DATA names their folder\n",
            stderr);
        return;
    }
    if (tshirt) append(hung_garment(folder / "tshirt-iso.obj", 0, "tshirt"), true);
    if (dress) append(hung_garment(folder / "dress-victor-iso-draped.obj", 0, "dress"), true);
    if (tshirt && !options.quick) append(hung_garment(folder / "tshirt-iso.obj", 1, "tshirt-fine"), true);
}

std::vector<Part> parts_of(const StudyOptions& options) {
    std::vector<Part> parts;
    const auto append = [&](StudyScene scene, bool is_garment) {
        auto points = points_for(options, scene, is_garment);
        parts.push_back({std::move(scene), std::move(points), is_garment});
    };
    std::vector<std::uint32_t> sizes = options.sizes;
    if (sizes.empty()) sizes = options.quick ? std::vector{32u, 64u} : std::vector{32u, 64u, 128u, 256u};
    for (const std::uint32_t n : sizes) {
        if (is_wanted(options, "hanging")) append(hung_sheet(n, false), false);
        const bool in_wind = is_wanted(options, "wind") && !(options.quick && n > 32);
        if (in_wind) append(hung_sheet(n, true), false);
    }
    append_garments(options, append);
    return parts;
}

bool uses_elements(const MethodPoint& point) {
    return point.applied_to({}).finite_elements.enabled;
}

class Accuracy {
  public:
    Accuracy(const StudyOptions& options, const std::vector<Part>& parts)
        : is_quick_(options.quick),
          fine_time_limit_(options.fine_time_limit),
          threads_(options.threads),
          table_(options.csv, accuracy_columns(), options.resume),
          store_(cache_folder(options), options.threads),
          progress_(count_of(parts), cost_of(parts)) {}

    void run(const Part& part) {
        if (is_complete(part)) {
            for (const MethodPoint& point : part.points) skip(part, point);
            progress_.skip(part.cost(work_of_references));
            return;
        }
        if (part.is_garment)
            run_garment(part);
        else
            run_sheet(part);
    }

  private:
    static std::filesystem::path cache_folder(const StudyOptions& options) {
        return options.cache.empty() ? options.csv.parent_path() / "references" : options.cache;
    }
    static std::size_t count_of(const std::vector<Part>& parts) {
        std::size_t count = 0;
        for (const Part& part : parts) count += 1 + rounds * part.points.size();
        return count;
    }
    static double cost_of(const std::vector<Part>& parts) {
        double cost = 0;
        for (const Part& part : parts) {
            cost += part.cost(work_of_references);
            for (const MethodPoint& point : part.points) cost += part.cost(work_of(point));
        }
        return cost;
    }

    static double cost_of_round(const Part& part, const MethodPoint& point) {
        return part.cost(work_of(point)) / rounds;
    }

    void skip(const Part& part, const MethodPoint& point) {
        for (int round = 0; round < rounds; ++round) progress_.skip(cost_of_round(part, point));
    }

    [[nodiscard]] bool is_complete(const Part& part) const {
        return std::ranges::all_of(part.points, [&](const MethodPoint& point) {
            return table_.find(identity(part.scene, point, threads_), accuracy_keys()) != nullptr;
        });
    }

    void run_sheet(const Part& part) {
        const std::vector<int> frames{ComparedFrames::half_second, ComparedFrames::second};
        std::map<Reference, States> references;
        progress_.begin(title(part) + " references");
        for (const Reference reference : all_references) {
            if (is_quick_ && reference == Reference::converged_bdf2) continue;
            if (reference == Reference::elements && std::ranges::none_of(part.points, uses_elements))
                continue;
            if (reference == Reference::fine_time && part.scene.mesh.positions.size() > fine_time_limit_)
                continue;
            references[reference] = store_.states(part.scene, reference, frames);
        }
        for (const auto& [reference, states] : references)
            append(compare_reference(part.scene, reference, references, threads_));
        progress_.end(part.cost(work_of_references));
        run_points(
            part,
            [&](const MethodPoint& point) {
                return measure_trajectory(part.scene, point, references, threads_);
            },
            [&](const MethodPoint& point) { return time_trajectory(part.scene, point, threads_); });
    }

    void run_garment(const Part& part) {
        progress_.begin(title(part) + " references");
        const GarmentSteps steps(part.scene, store_, threads_);
        progress_.end(part.cost(work_of_references));
        run_points(
            part, [&](const MethodPoint& point) { return measure_steps(steps, point, threads_); },
            [&](const MethodPoint& point) { return time_steps(steps, point, threads_); });
    }

    /// A point of the part at hand that is timed in further rounds.
    struct Entry {
        const MethodPoint* point;
        Measured measured;
    };

    // Times points in rounds over all of them: a slow minute of the machine then falls on all, and the median
    // of the rounds leaves it out. Rows are in the table after the first round, so that a run that was
    // stopped can be resumed.
    template <class Measure, class Time>
    void run_points(const Part& part, const Measure& measure, const Time& time) {
        std::vector<Entry> entries;
        for (const MethodPoint& point : part.points) {
            if (table_.find(identity(part.scene, point, threads_), accuracy_keys()) != nullptr) {
                skip(part, point);
                continue;
            }
            progress_.begin(title(part) + " " + point.name + " " + point.setting);
            // Warm-up: caches and clocks are cold in the first run of all.
            if (entries.empty()) (void)time(point);
            entries.push_back({&point, measure(point)});
            put_times(entries.back().measured.row, entries.back().measured.milliseconds);
            append(entries.back().measured.row);
            progress_.end(cost_of_round(part, point));
        }
        for (int round = 1; round < rounds; ++round) {
            for (Entry& entry : entries) {
                const double cost = cost_of_round(part, *entry.point);
                std::vector<double>& all = entry.measured.milliseconds;
                if (sum(all) > longest_run * round) {
                    progress_.skip(cost);
                    continue;
                }
                progress_.begin(title(part) + " " + entry.point->name + " " + entry.point->setting +
                                ", round " + std::to_string(round + 1));
                const std::vector<double> more = time(*entry.point);
                all.insert(all.end(), more.begin(), more.end());
                put_times(entry.measured.row, all);
                table_.replace(entry.measured.row, accuracy_keys());
                progress_.end(cost);
            }
        }
    }

    void append(const CsvRow& row) {
        if (table_.find(row, accuracy_keys()) == nullptr) table_.append(row);
    }

    static std::string title(const Part& part) {
        return part.scene.name + (part.scene.per_side > 0 ? " " + std::to_string(part.scene.per_side) : "");
    }

    bool is_quick_;
    std::uint32_t fine_time_limit_;
    int threads_;
    CsvWriter table_;
    ReferenceStore store_;
    StudyProgress progress_;
};

}  // namespace

int run_accuracy(const StudyOptions& options) {
    const std::vector<Part> parts = parts_of(options);
    Accuracy accuracy(options, parts);
    for (const Part& part : parts) accuracy.run(part);
    return 0;
}

}  // namespace weft::study
