#include "demo/study/contact/contact_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

#include "demo/headless/frame_table.h"
#include "demo/study/charts/charts.h"
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
        result_.median_step = demo::percentile(times_, 0.5);
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

namespace {

std::string shown(const std::string& field, const char* format = "%.3g") {
    const auto value = parse_number(field);
    if (!value) return "-";
    char text[32];
    std::snprintf(text, sizeof text, format, *value);
    return text;
}

/// Two fields, or a dash where the scene has neither.
std::string both(const std::string& first, const std::string& second) {
    return first == "-" && second == "-" ? "-" : first + " / " + second;
}

std::string layers_of(const CsvRow& row) {
    const double layers = parse_number(row.at("layers")).value_or(0);
    if (layers < 2) return "-";
    return row.at("layers_in_order") + " of " + number(layers - 1);
}

}  // namespace

const std::vector<std::string>& contact_columns() {
    static const std::vector<std::string> columns{
        "machine",         "commit",          "scene",        "rung",
        "asked",           "every",           "particles",    "crossings_peak",
        "crossings_final", "between_final",   "clean_from_s", "gap_mm",
        "stretch_worst",   "stretch_final",   "stretch_mean", "rest_mms",
        "deepest_mm",      "deepest_end_mm",  "pin_lag_mm",   "momentum_drift",
        "layers",          "layers_in_order", "median_ms",    "unsolved_steps",
        "restored_steps"};
    return columns;
}

const std::vector<std::string>& contact_keys() {
    static const std::vector<std::string> keys{"scene", "rung", "asked", "every"};
    return keys;
}

bool is_contact_table(const CsvTable& table) {
    return table.columns == contact_columns();
}

CsvRow contact_key(const std::string& scene, SelfCollisionMethod method, std::uint32_t particles, int every) {
    return {{"scene", scene},
            {"rung", name_of(method)},
            {"asked", std::to_string(particles)},
            {"every", std::to_string(every)}};
}

CsvRow contact_row(CsvRow row, const ContactResult& result) {
    const auto whole = [](auto count) { return std::to_string(count); };
    const auto thousandths = [](double value) { return number(1000 * value); };
    row["particles"] = whole(result.particles);
    row["crossings_peak"] = whole(result.crossings_peak);
    row["crossings_final"] = whole(result.crossings_final);
    row["between_final"] = whole(result.between_final);
    row["clean_from_s"] = number(result.clean_from);
    row["gap_mm"] = thousandths(result.gap);
    row["stretch_worst"] = number(result.stretch_worst);
    row["stretch_final"] = number(result.stretch_final);
    row["stretch_mean"] = number(result.stretch_mean);
    row["rest_mms"] = thousandths(result.rest_speed);
    row["deepest_mm"] = thousandths(result.deepest);
    row["deepest_end_mm"] = thousandths(result.deepest_final);
    row["pin_lag_mm"] = thousandths(result.pin_lag);
    row["momentum_drift"] = number(result.momentum_drift);
    row["layers"] = whole(result.layers);
    row["layers_in_order"] = whole(result.layers_in_order);
    row["median_ms"] = thousandths(result.median_step);
    row["unsolved_steps"] = whole(result.unsolved_steps);
    row["restored_steps"] = whole(result.restored_steps);
    return row;
}

std::string contact_markdown(const CsvTable& table) {
    std::string text =
        "| scene | rung | particles | crossing pairs: peak / final | clean from [s] | least gap [mm] | "
        "longest "
        "edge: worst / final | mean edge | rest [mm/s] | in colliders' distance: deepest / final [mm] | "
        "pins lag [mm] | momentum drift | layers in order | step [ms] |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const CsvRow& row : table.rows) {
        for (const std::string& cell :
             {row.at("scene"), row.at("rung"), row.at("particles"),
              both(row.at("crossings_peak"), row.at("crossings_final")), shown(row.at("clean_from_s")),
              shown(row.at("gap_mm")), both(shown(row.at("stretch_worst")), shown(row.at("stretch_final"))),
              shown(row.at("stretch_mean"), "%.4g"), shown(row.at("rest_mms")),
              both(shown(row.at("deepest_mm"), "%.1f"), shown(row.at("deepest_end_mm"), "%.1f")),
              shown(row.at("pin_lag_mm"), "%.1f"), shown(row.at("momentum_drift")), layers_of(row),
              shown(row.at("median_ms"))})
            text.append("| ").append(cell).append(" ");
        text.append("|\n");
    }
    return text;
}

}  // namespace weft::study
