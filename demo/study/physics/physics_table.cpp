#include "demo/study/physics/physics_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "demo/study/charts/charts.h"

namespace weft::study {

namespace {

/// The number of a field with four digits, or a dash if it has none.
std::string shown(const std::string& field) {
    const auto value = parse_number(field);
    if (!value) return "-";
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", *value);
    return text;
}

std::string shown_range(const CsvRow& row) {
    const std::string least = shown(row.at("known_least")), most = shown(row.at("known_most"));
    return least == most ? least : least + " to " + most;
}

std::string shown_error(const CsvRow& row) {
    const auto error = parse_number(row.at("error"));
    if (!error) return "-";
    if (row.at("known_least") != row.at("known_most") && *error == 0) return "within";
    char text[32];
    std::snprintf(text, sizeof text, "%+.1f %%", 100 * *error);
    return text;
}

}  // namespace

double error_of(const Finding& finding) {
    if (!std::isfinite(finding.measured)) return finding.measured;
    const double beyond = finding.measured - std::clamp(finding.measured, finding.least, finding.most);
    const double known = finding.measured > finding.most ? finding.most : finding.least;
    return known == 0 ? beyond : beyond / std::abs(known);
}

const std::vector<std::string>& physics_columns() {
    static const std::vector<std::string> columns{
        "machine", "commit",   "test",        "model",      "cells", "quantity", "vertices",
        "unit",    "measured", "known_least", "known_most", "error", "seconds"};
    return columns;
}

const std::vector<std::string>& physics_keys() {
    static const std::vector<std::string> keys{"test", "model", "cells"};
    return keys;
}

bool is_physics_table(const CsvTable& table) {
    return table.columns == physics_columns();
}

CsvRow physics_row(const PhysicsTest& test, const Finding* finding) {
    // The CSV's texts hold no comma.
    const auto plain = [](std::string text) {
        std::erase(text, ',');
        return text;
    };
    CsvRow row{{"test", plain(test.name)},
               {"model", plain(name_of(test.model))},
               {"cells", std::to_string(test.cells)}};
    if (finding != nullptr) {
        row["quantity"] = plain(finding->quantity);
        row["vertices"] = finding->cells > 0 ? std::to_string(finding->cells) : "";
        row["unit"] = finding->unit;
        row["measured"] = number(finding->measured);
        row["known_least"] = number(finding->least);
        row["known_most"] = number(finding->most);
        row["error"] = number(error_of(*finding));
    }
    return row;
}

std::string physics_markdown(const CsvTable& table) {
    std::string text =
        "| test | force model | cells | quantity | measured | known | error "
        "|\n|---|---|---|---|---|---|---|\n";
    for (const CsvRow& row : table.rows) {
        const std::string& vertices = row.at("vertices");
        const std::string cells = vertices.empty() ? row.at("cells") : vertices + " vertices";
        const std::string unit = row.at("unit").empty() ? "" : " [" + row.at("unit") + "]";
        for (const std::string& cell : {row.at("test"), row.at("model"), cells, row.at("quantity") + unit,
                                        shown(row.at("measured")), shown_range(row), shown_error(row)})
            text.append("| ").append(cell).append(" ");
        text.append("|\n");
    }
    return text;
}

}  // namespace weft::study
