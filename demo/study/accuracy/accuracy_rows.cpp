#include "demo/study/accuracy/accuracy_rows.h"
#include "demo/headless/frame_table.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "demo/study/accuracy/motion_measures.h"
#include "demo/study/machine.h"
#include "demo/study/study_options.h"

namespace weft::study {

namespace {

constexpr int half_second = 30, one_second = 60;  // in frames

std::string error_column(const std::string& from, int frame) {
    return from + (frame == half_second ? "_0.5s_mm" : "_1s_mm");
}

void put_errors(CsvRow& row, const std::string& from, const States& states, const States& reference) {
    for (const auto& [frame, positions] : states)
        row[error_column(from, frame)] = number(1000 * rms_distance(positions, reference.at(frame)));
}

void put_stretch(CsvRow& row, const ClothModel& model, const States& states) {
    const Stretch stretch = structural_stretch(model, states.rbegin()->second);
    row["worst_stretch_percent"] = number(100 * (stretch.worst - 1));
    row["mean_stretch_percent"] = number(100 * (stretch.mean - 1));
}

/// The converged step of the method's own time scheme. None for substeps and for methods that solve no
/// equation.
std::optional<Reference> own_reference(const Cloth& cloth) {
    if (!cloth.solver->is_implicit() || cloth.settings.substeps > 1) return {};
    const bool is_bdf2 = resolved(cloth.settings.time_scheme, cloth.settings.method) == TimeScheme::bdf2;
    return is_bdf2 ? Reference::converged_bdf2 : Reference::converged;
}

}  // namespace

std::vector<int> compared_frames(const StudyScene& scene) {
    return scene.per_side > 0 ? std::vector{half_second, one_second} : std::vector{half_second};
}

std::vector<std::string> accuracy_columns() {
    std::vector<std::string> columns{"machine", "commit",  "scene",  "n",         "particles",
                                     "kappa",   "threads", "method", "label",     "setting",
                                     "default", "status",  "frames", "median_ms", "p99_ms"};
    for (const char* const from : {"truth", "own"})
        for (const int frame : {half_second, one_second}) columns.push_back(error_column(from, frame));
    for (const char* const column : {"worst_stretch_percent", "mean_stretch_percent"})
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
    row["median_ms"] = number(demo::percentile(milliseconds, 0.5));
    row["p99_ms"] = number(demo::percentile(milliseconds, 0.99));
}

Measured measure_trajectory(const StudyScene& scene, const MethodPoint& point,
                            const std::map<Reference, States>& references, int threads) {
    Run run(scene, point, threads);
    const std::unique_ptr<Peer> peer = point.make_peer ? point.make_peer(scene, run.cloth()) : nullptr;
    constexpr int warm_up = 5;  // frames that are not timed
    bool lost = false;          // not finite, or so fast that the world's speed limit held it
    States states;
    Measured measured;
    const std::vector<int> compared = compared_frames(scene);
    for (int frame = 1; frame <= compared.back(); ++frame) {
        const double milliseconds = peer ? peer->step(scene.frame) : run.step();
        if (frame > warm_up) measured.milliseconds.push_back(milliseconds);
        lost = lost || has(run.report().flags, StepFlags::state_restored) ||
               has(run.report().flags, StepFlags::speed_limited);
        if (std::ranges::find(compared, frame) != compared.end())
            states[frame] = peer ? peer->positions() : positions_of(run.cloth());
    }

    CsvRow& row = measured.row = identity(scene, point, threads);
    row["particles"] = std::to_string(run.cloth().model.particle_count);
    row["kappa"] = number(kappa(run.cloth(), static_cast<double>(scene.frame)));
    row["status"] = lost ? "diverged" : "ok";
    put_stretch(row, run.cloth().model, states);
    if (const auto truth = references.find(Reference::fine_time); truth != references.end())
        put_errors(row, "truth", states, truth->second);
    if (const auto own = own_reference(run.cloth()); own && !peer && references.contains(*own))
        put_errors(row, "own", states, references.at(*own));
    return measured;
}

CsvRow compare_reference(const StudyScene& scene, Reference reference,
                         const std::map<Reference, States>& references, int threads) {
    CsvRow row = identity(scene, method_of(reference), threads);
    row["status"] = "reference";
    put_stretch(row, cook(scene.mesh).value(), references.at(reference));
    if (const auto truth = references.find(Reference::fine_time);
        truth != references.end() && reference != Reference::fine_time)
        put_errors(row, "truth", references.at(reference), truth->second);
    return row;
}

}  // namespace weft::study
