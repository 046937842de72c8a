#include "demo/study/accuracy/accuracy_rows.h"

#include <algorithm>
#include <utility>

#include "demo/study/accuracy/energy.h"
#include "demo/study/accuracy/stretch.h"
#include "demo/study/machine.h"
#include "demo/study/study_options.h"

namespace weft::study {

namespace {

/// A reference as the table's columns name it.
struct NamedReference {
    Reference reference;
    std::string name;
};
const std::vector<NamedReference> compared{
    {Reference::converged, "a"}, {Reference::linearised, "a1"}, {Reference::fine_time, "b"}};

struct NamedFrame {
    int frame;
    std::string name;
};
const std::vector<NamedFrame> moments{{ComparedFrames::half_second, "0.5s"}, {ComparedFrames::second, "1s"}};

std::string error_column(const std::string& reference, const std::string& moment, const std::string& unit) {
    return "error_" + reference + "_" + moment + "_" + unit;
}

void put_error(CsvRow& row, const std::string& reference, const std::string& moment, double rms,
               double side) {
    row[error_column(reference, moment, "mm")] = number(1000 * rms);
    row[error_column(reference, moment, "percent")] = number(100 * rms / side);
}

/// Longest side of the box around the mesh [m].
double side_of(const Mesh& mesh) {
    Vector3 lower = to_vector(mesh.positions.front()), upper = lower;
    for (const Vec3& p : mesh.positions) {
        lower = lower.cwiseMin(to_vector(p));
        upper = upper.cwiseMax(to_vector(p));
    }
    return static_cast<double>((upper - lower).maxCoeff());
}

void put_errors(CsvRow& row, const StudyScene& scene, const States& states, const std::string& name,
                const States& reference) {
    for (const NamedFrame& moment : moments) {
        const auto state = states.find(moment.frame), other = reference.find(moment.frame);
        if (state == states.end() || other == reference.end()) continue;
        put_error(row, name, moment.name, rms_distance(state->second, other->second), side_of(scene.mesh));
    }
}

void put_stretch(CsvRow& row, const Stretch& stretch) {
    row["worst_stretch_percent"] = number(100 * (stretch.worst - 1));
    row["mean_stretch_percent"] = number(100 * (stretch.mean - 1));
}

/// The converged run of the point's own force model and time scheme at the frame's step, which separates the
/// solver's error from the time scheme's. Null for substeps and for methods that solve no equation.
const States* own_reference(const Cloth& cloth, const std::map<Reference, States>& references) {
    if (!cloth.solver->is_implicit() || cloth.settings.substeps > 1) return nullptr;
    const bool is_bdf2 = resolved(cloth.settings.time_scheme, cloth.settings.method) == TimeScheme::bdf2;
    const auto at = references.find(cloth.settings.finite_elements.enabled ? Reference::elements
                                    : is_bdf2                              ? Reference::converged_bdf2
                                                                           : Reference::converged);
    return at == references.end() ? nullptr : &at->second;
}

constexpr int warm_up = 5;  // frames that are not timed

/// The states and times of a run, to be compared.
struct Outcome {
    States states;
    std::vector<double> milliseconds;
    bool lost = false;  // not finite, or so fast that the world's speed limit held it
};

Outcome run_to(Run& run, int frames) {
    Outcome outcome;
    for (int frame = 1; frame <= frames; ++frame) {
        const double milliseconds = run.step();
        if (frame > warm_up) outcome.milliseconds.push_back(milliseconds);
        if (has(run.report().flags, StepFlags::state_restored) ||
            has(run.report().flags, StepFlags::speed_limited))
            outcome.lost = true;
        if (frame == ComparedFrames::half_second || frame == ComparedFrames::second)
            outcome.states[frame] = positions_of(run.cloth());
    }
    return outcome;
}

}  // namespace

std::vector<std::string> accuracy_columns() {
    std::vector<std::string> columns{"machine", "commit",  "scene",  "n",         "particles",
                                     "kappa",   "threads", "method", "label",     "setting",
                                     "default", "status",  "frames", "median_ms", "p99_ms"};
    for (const char* const reference : {"a", "a1", "b", "own"}) {
        for (const NamedFrame& moment : moments) {
            columns.push_back(error_column(reference, moment.name, "mm"));
            columns.push_back(error_column(reference, moment.name, "percent"));
        }
    }
    for (const char* const column : {"error_a_step_mm", "error_a_step_percent", "energy_gap",
                                     "worst_stretch_percent", "mean_stretch_percent", "energy_2s_J"})
        columns.emplace_back(column);
    return columns;
}

std::vector<std::string> accuracy_keys() {
    return {"scene", "n", "threads", "method", "setting"};
}

CsvRow identity(const StudyScene& scene, const MethodPoint& point, int threads) {
    static const std::string machine = machine_name(), commit = commit_name();
    return {{"machine", machine},
            {"commit", commit},
            {"scene", scene.name},
            {"n", std::to_string(scene.per_side)},
            {"threads", std::to_string(thread_count(threads))},
            {"method", point.name},
            {"label", point.label},
            {"setting", point.setting},
            {"default", point.is_default ? "yes" : "no"}};
}

void put_times(CsvRow& row, const std::vector<double>& milliseconds) {
    row["frames"] = std::to_string(milliseconds.size());
    row["median_ms"] = number(quantile(milliseconds, 0.5));
    row["p99_ms"] = number(quantile(milliseconds, 0.99));
}

Measured measure_trajectory(const StudyScene& scene, const MethodPoint& point,
                            const std::map<Reference, States>& references, int threads) {
    Run run(scene, point, threads);
    CsvRow row = identity(scene, point, threads);
    row["particles"] = std::to_string(run.cloth().model.particle_count);
    row["kappa"] = number(kappa(run.cloth(), static_cast<double>(scene.frame)));

    Outcome outcome = run_to(run, ComparedFrames::second);
    put_stretch(row, structural_stretch(run.cloth().model, outcome.states.at(ComparedFrames::second)));
    for (const NamedReference& reference : compared) {
        if (run.cloth().settings.finite_elements.enabled) break;  // these are of springs, another material
        if (const auto at = references.find(reference.reference); at != references.end())
            put_errors(row, scene, outcome.states, reference.name, at->second);
    }
    if (const States* const own = own_reference(run.cloth(), references))
        put_errors(row, scene, outcome.states, "own", *own);

    const Outcome rest = run_to(run, ComparedFrames::last - ComparedFrames::second);
    row["energy_2s_J"] = number(energy_of(run.cloth(), scene.world.gravity).total());
    row["status"] = outcome.lost || rest.lost ? "diverged" : "ok";
    return {std::move(row), std::move(outcome.milliseconds)};
}

std::vector<double> time_trajectory(const StudyScene& scene, const MethodPoint& point, int threads) {
    Run run(scene, point, threads);
    return run_to(run, ComparedFrames::second).milliseconds;
}

CsvRow compare_reference(const StudyScene& scene, Reference reference,
                         const std::map<Reference, States>& references, int threads) {
    CsvRow row = identity(scene, method_of(reference), threads);
    row["status"] = "reference";
    const States& states = references.at(reference);
    const ClothModel model = cook(scene.mesh).value();
    put_stretch(row, structural_stretch(model, states.at(ComparedFrames::second)));
    for (const NamedReference& other : compared) {
        if (reference == Reference::elements) break;
        if (other.reference != reference && references.contains(other.reference))
            put_errors(row, scene, states, other.name, references.at(other.reference));
    }
    return row;
}

namespace {

/// Repeats the step from state s; the first repeat is not timed.
void time_step(const GarmentSteps& steps, std::size_t s, Run& run, std::vector<double>& milliseconds) {
    constexpr int timed_repeats = 3;
    for (int repeat = 0; repeat <= timed_repeats; ++repeat) {
        run.restart(steps.start(s));
        const double step_milliseconds = run.step();
        if (repeat > 0) milliseconds.push_back(step_milliseconds);
    }
}

}  // namespace

Measured measure_steps(const GarmentSteps& steps, const MethodPoint& point, int threads) {
    const StudyScene& garment = steps.garment();
    Run run(steps.start(0), point, threads);
    CsvRow row = identity(garment, point, threads);
    row["particles"] = std::to_string(run.cloth().model.particle_count);
    row["kappa"] = number(kappa(run.cloth(), static_cast<double>(garment.frame)));

    std::vector<double> milliseconds;
    double rms = 0, gap = 0;
    Stretch stretch{0, 0};
    const auto count = static_cast<double>(steps.size());
    for (std::size_t s = 0; s < steps.size(); ++s) {
        time_step(steps, s, run, milliseconds);
        const GarmentSteps::Judgement judgement = steps.judge(s, run.cloth());
        const Stretch after = structural_stretch(run.cloth().model, positions_of(run.cloth()));
        rms += judgement.rms / count;
        gap += judgement.energy_gap / count;
        stretch = {std::max(stretch.worst, after.worst), stretch.mean + after.mean / count};
    }
    row["error_a_step_mm"] = number(1000 * rms);
    row["error_a_step_percent"] = number(100 * rms / side_of(garment.mesh));
    row["energy_gap"] = number(gap);
    put_stretch(row, stretch);
    row["status"] = run.restored_frames() > 0 ? "diverged" : "ok";
    return {std::move(row), std::move(milliseconds)};
}

std::vector<double> time_steps(const GarmentSteps& steps, const MethodPoint& point, int threads) {
    Run run(steps.start(0), point, threads);
    std::vector<double> milliseconds;
    for (std::size_t s = 0; s < steps.size(); ++s) time_step(steps, s, run, milliseconds);
    return milliseconds;
}

}  // namespace weft::study
