// weft_study accuracy: every method over its settings against the references.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>
#include <numeric>

#include "demo/study/accuracy/accuracy_rows.h"
#include "demo/study/machine.h"
#include "demo/study/run.h"
#include "demo/study/study_options.h"

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
    const std::vector<std::string> quick{"hanging", "wind"}, usual{"hanging", "wind", "tshirt"};
    const auto& wanted = !options.scenes.empty() ? options.scenes : options.quick ? quick : usual;
    return std::ranges::find(wanted, scene) != wanted.end();
}

std::vector<Part> parts_of(const StudyOptions& options) {
    std::vector<Part> parts;
    const auto append = [&](const char* name, const auto& make) {
        if (!is_wanted(options, name)) return;
        StudyScene scene = make();
        auto points =
            only_named(method_points(options.quick ? Coverage::quick : Coverage::all, scene), options.only);
        parts.push_back({std::move(scene), std::move(points)});
    };
    const std::vector<std::uint32_t> usual{options.quick ? 32u : 64u};
    for (const std::uint32_t n : options.sizes.empty() ? usual : options.sizes) {
        append("hanging", [&] { return hung_sheet(n, false); });
        append("wind", [&] { return hung_sheet(n, true); });
    }
    const std::filesystem::path folder = garment_folder(options);
    if (folder.empty()) {
        std::fputs(
            "weft_study: garments are left out, since neither --garments nor WEFT_DATA names their folder\n",
            stderr);
        return parts;
    }
    append("tshirt", [&] { return hung_garment(folder / "tshirt-iso.obj", "tshirt"); });
    append("dress", [&] { return hung_garment(folder / "dress-victor-iso-draped.obj", "dress"); });
    return parts;
}

class Accuracy {
  public:
    Accuracy(const StudyOptions& options, const std::vector<Part>& parts)
        : fine_time_limit_(options.fine_time_limit),
          threads_(options.threads),
          table_(options.csv, accuracy_columns(), options.resume),
          store_(cache_folder(options)),
          progress_(count_of(parts), cost_of(parts)) {}

    void run(const Part& part) {
        if (is_complete(part)) {
            for (const MethodPoint& point : part.points) skip(part, point);
            progress_.skip(part.cost(work_of_references));
            return;
        }
        std::map<Reference, States> references;
        progress_.begin(title(part) + " references");
        for (const Reference reference : all_references) {
            if (!is_truth(reference) || part.scene.mesh.positions.size() <= fine_time_limit_)
                references[reference] = store_.states(part.scene, reference, compared_frames(part.scene));
        }
        for (const auto& [reference, states] : references)
            table_.replace(compare_reference(part.scene, reference, references, threads_), accuracy_keys());
        progress_.end(part.cost(work_of_references));
        run_points(part, references);
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

    /// A point that the table lacks, with the times of the rounds so far.
    struct Entry {
        const MethodPoint* point;
        std::vector<double> milliseconds;
    };

    // Points are measured in rounds over all of them: a slow minute of the machine then falls on all, and the
    // median of the rounds leaves it out. Rows are in the table after the first round, so that a run that was
    // stopped can be resumed.
    void run_points(const Part& part, const std::map<Reference, States>& references) {
        std::vector<Entry> entries;
        for (const MethodPoint& point : part.points) {
            if (table_.find(identity(part.scene, point, threads_), accuracy_keys()) != nullptr)
                skip(part, point);
            else
                entries.push_back({&point, {}});
        }
        for (int round = 0; round < rounds; ++round) {
            for (Entry& entry : entries) {
                const double cost = cost_of_round(part, *entry.point);
                if (sum(entry.milliseconds) > longest_run * round)
                    progress_.skip(cost);
                else
                    run_point(part, entry, references, cost);
            }
        }
    }

    void run_point(const Part& part, Entry& entry, const std::map<Reference, States>& references,
                   double cost) {
        progress_.begin(title(part) + " " + entry.point->name + " " + entry.point->setting);
        Measured measured = measure_trajectory(part.scene, *entry.point, references, threads_);
        std::ranges::copy(measured.milliseconds, std::back_inserter(entry.milliseconds));
        put_times(measured.row, entry.milliseconds);
        table_.replace(measured.row, accuracy_keys());
        progress_.end(cost);
    }

    static std::string title(const Part& part) {
        return part.scene.name + (part.scene.per_side > 0 ? " " + std::to_string(part.scene.per_side) : "");
    }

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
