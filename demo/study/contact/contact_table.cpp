#include "demo/study/contact/contact_table.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace weft::study {

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
