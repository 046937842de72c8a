#include "demo/study/charts/charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <vector>

#include "demo/study/charts/gnuplot.h"
#include "demo/study/machine.h"
#include "demo/study/physics/physics_table.h"

namespace weft::study {

namespace {

/// Errors are clamped to this range [%].
constexpr double least_shown = 0.1, most_shown = 300;

constexpr std::array<const char*, 3> colours{"#1f77b4", "#d62728", "#2ca02c"};  // of force_models

struct Point {
    int line;
    double percent, cells;
    std::string model;
};

/// The lines of the chart: test and quantity, in the order of the table, and the points of all.
struct Lines {
    std::vector<std::string> titles;
    std::vector<Point> points;
};

Lines lines_of(const CsvTable& table) {
    Lines lines;
    std::map<std::string, int> line_of;
    for (const CsvRow& row : table.rows) {
        const auto error = parse_number(row.at("error"));
        if (!error) continue;
        const std::string title = row.at("test") + ": " + row.at("quantity");
        const auto [entry, fresh] = line_of.try_emplace(title, static_cast<int>(lines.titles.size()));
        if (fresh) lines.titles.push_back(title);
        const std::string& vertices = row.at("vertices");
        lines.points.push_back({entry->second, std::clamp(100 * std::abs(*error), least_shown, most_shown),
                                parse_number(vertices.empty() ? row.at("cells") : vertices).value_or(0),
                                row.at("model")});
    }
    return lines;
}

}  // namespace

void draw_physics(const CsvTable& table, const std::filesystem::path& folder) {
    const Lines lines = lines_of(table);
    std::ostringstream settings, plot;
    settings << "set title 'Error of what is measured beside what is known'\nset logscale x\nset xrange ["
             << 0.8 * least_shown << ":" << 1.2 * most_shown << "]\nset yrange ["
             << static_cast<double>(lines.titles.size()) - 0.5 << ":-0.5]\nset xlabel "
             << quoted("error [%], at least 0.1; larger marks are finer meshes")
             << "\nset grid\nset key outside top center horizontal\nset ytics (";
    for (std::size_t i = 0; i < lines.titles.size(); ++i)
        settings << (i > 0 ? ", " : "") << quoted(lines.titles[i]) << ' ' << i;
    settings << ")\n";
    for (std::size_t m = 0; m < force_models.size(); ++m) {
        settings << "$model" << m << " << EOD\n";
        std::string model = name_of(force_models[m]);
        std::erase(model, ',');
        for (const Point& point : lines.points) {
            if (point.model != model) continue;
            double finest = 1;
            for (const Point& other : lines.points)
                if (other.line == point.line) finest = std::max(finest, other.cells);
            const double size = 0.6 + 1.0 * point.cells / finest;
            settings << point.percent << ' ' << point.line + 0.22 * (static_cast<double>(m) - 1) << ' '
                     << size << '\n';
        }
        settings << "EOD\n";
    }
    plot << "plot ";
    for (std::size_t m = 0; m < force_models.size(); ++m)
        plot << (m > 0 ? ", " : "") << "$model" << m
             << " using 1:2:3 with points pointtype 7 pointsize variable "
             << "linecolor rgb " << quoted(colours[m]) << " title " << quoted(name_of(force_models[m]));
    plot << '\n';
    const int height = 140 + 22 * static_cast<int>(lines.titles.size());
    draw_with_gnuplot(folder / "physics", {1000, height, origin_of(table, "physics")}, settings.str(),
                      plot.str());
}

}  // namespace weft::study
