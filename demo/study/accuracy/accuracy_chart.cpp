#include "demo/study/charts/charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <ranges>
#include <span>
#include <sstream>
#include <tuple>
#include <utility>

#include "demo/study/charts/gnuplot.h"
#include "demo/study/machine.h"

namespace weft::study {

namespace {

struct CostAndError {
    double cost, error;
};

/// Indices of the points of which no other is as good in both and better in one (Pareto 1906), in ascending
/// order of cost. Equal points are represented by the first.
std::vector<std::size_t> front_of(std::span<const CostAndError> points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {},
                             [&](std::size_t i) { return std::tuple(points[i].cost, points[i].error); });
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (points[i].error >= least) continue;
        least = points[i].error;
        front.push_back(i);
    }
    return front;
}

/// One chart that is drawn of every scene that has the column.
struct Kind {
    std::string file, title, axis, column;
    bool has_front;
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        {"truth-0.5s", "distance from the true motion after 0.5 s", "RMS distance of particles [mm]",
         "truth_0.5s_mm", true},
        {"truth-1s", "distance from the true motion after 1 s", "RMS distance of particles [mm]",
         "truth_1s_mm", true},
        {"own-0.5s", "distance from the method's own converged step after 0.5 s",
         "RMS distance of particles [mm]", "own_0.5s_mm", false},
        {"stretch", "worst stretch of a thread after", "worst stretch [%]", "worst_stretch_percent", false},
    };
    return all;
}

/// The name of a reference's level in a chart.
std::string level_name(const std::string& reference) {
    if (reference == "converged") return "backward Euler, converged";
    if (reference == "converged-bdf2") return "BDF2, converged";
    return reference == "moved-start" ? "the truth, started 1 µm off" : "the true motion";
}

/// How a curve looks: families by colour, members by shade and mark.
struct Style {
    const char* colour;
    int mark;
};

Style style_of(const std::string& method) {
    static const std::map<std::string, Style> styles{
        {"jacobi", {"#d62728", 7}},
        {"jacobi-tethers", {"#8c1515", 9}},
        {"jacobi-substeps", {"#e8590c", 8}},
        {"chebyshev", {"#f59f00", 5}},
        {"cg", {"#b8860b", 13}},
        {"multilevel", {"#0b3d91", 5}},
        {"multilevel-substeps-1", {"#15aabf", 8}},
        {"multilevel-substeps-3", {"#1f77b4", 9}},
        {"multilevel-euler", {"#2b8a3e", 5}},
        {"multilevel-euler-substeps", {"#74b816", 8}},
        {"xpbd", {"#9c36b5", 7}},
        {"xpbd-iterations", {"#da77f2", 6}},
        {"fibres", {"#e64980", 13}},
        {"fibres-substeps", {"#f783ac", 12}},
        {"symplectic-euler", {"#495057", 15}},
        {"cholesky", {"#000000", 2}},
        {"bullet", {"#5c3a1e", 11}},
    };
    const auto at = styles.find(method);
    return at == styles.end() ? Style{"#868e96", 1} : at->second;
}

struct MeasuredSetting {
    CostAndError at;
    std::string setting;
};

struct Curve {
    std::string method, label;
    std::vector<MeasuredSetting> points;
};

/// All rows of one scene at one size.
using Rows = std::vector<const CsvRow*>;

std::optional<double> positive(const CsvRow& row, const std::string& column) {
    const auto value = parse_number(row.at(column));
    return value && *value > 0 ? value : std::nullopt;
}

/// The rows that can be drawn. Those of the default are in `defaults` as well, for their mark.
struct Chart {
    std::vector<Curve> curves;
    std::vector<MeasuredSetting> defaults;
    std::vector<std::pair<std::string, double>> levels;
    std::map<std::string, std::string> diverged;  ///< settings by the curve's label
};

Chart chart_of(const Rows& rows, const Kind& kind) {
    Chart chart;
    for (const CsvRow* const row : rows) {
        if (row->at("status") == "diverged") {
            std::string& settings = chart.diverged[row->at("label")];
            settings += (settings.empty() ? " " : ", ") + row->at("setting");
        }
        const auto error = positive(*row, kind.column), cost = positive(*row, "median_ms");
        if (row->at("status") == "reference" && error)
            chart.levels.emplace_back(level_name(row->at("method")), *error);
        if (row->at("status") != "ok" || !error || !cost) continue;
        const MeasuredSetting measured{{*cost, *error}, row->at("setting")};
        if (row->at("default") == "yes") chart.defaults.push_back(measured);
        const auto at = std::ranges::find(chart.curves, row->at("method"), &Curve::method);
        Curve& curve = at != chart.curves.end()
                           ? *at
                           : chart.curves.emplace_back(Curve{row->at("method"), row->at("label"), {}});
        curve.points.push_back(measured);
    }
    for (Curve& curve : chart.curves)
        std::ranges::sort(curve.points, {}, [](const MeasuredSetting& point) { return point.at.cost; });
    return chart;
}

/// The front over all curves.
std::vector<MeasuredSetting> front_of_chart(const Chart& chart) {
    std::vector<MeasuredSetting> all;
    for (const Curve& curve : chart.curves) all.insert(all.end(), curve.points.begin(), curve.points.end());
    std::vector<CostAndError> points;
    for (const MeasuredSetting& measured : all) points.push_back(measured.at);
    std::vector<MeasuredSetting> front;
    for (const std::size_t i : front_of(points)) front.push_back(all[i]);
    return front;
}

std::string data_block(const std::string& name, const std::vector<MeasuredSetting>& points) {
    std::ostringstream text;
    text << '$' << name << " << END\n";
    for (const MeasuredSetting& point : points) {
        text << point.at.cost << ' ' << point.at.error << " \"" << point.setting << "\"\n";
    }
    text << "END\n";
    return text.str();
}

std::string scene_title(const CsvRow& row) {
    static const std::map<std::string, std::string> titles{{"hanging", "Sheet hung by two corners"},
                                                           {"wind", "Hung sheet in wind"},
                                                           {"tshirt", "T-shirt hung by its neck"},
                                                           {"dress", "Dress hung by its neck"}};
    const auto at = titles.find(row.at("scene"));
    const std::string title = at == titles.end() ? row.at("scene") : at->second;
    if (row.at("n") != "0") return title + ", " + row.at("n") + " × " + row.at("n") + " particles";
    return title + ", " + row.at("particles") + " particles";
}

/// "Sheet hung by two corners, 64 × 64 particles: worst stretch of a thread after 1 s"
std::string title_of(const Kind& kind, const CsvRow& row) {
    std::string title = scene_title(row) + ": " + kind.title;
    if (title.ends_with("after")) title += row.at("n") == "0" ? " 0.5 s" : " 1 s";
    return title;
}

/// The first row of a method: rows of references have no particles.
const CsvRow& described(const Rows& rows) {
    const auto at =
        std::ranges::find_if(rows, [](const CsvRow* row) { return !row->at("particles").empty(); });
    return at == rows.end() ? *rows.front() : **at;
}

/// The machine, the commit and the settings that are not drawn, in lines that fit the picture.
std::string footer_of(const CsvTable& table, const CsvRow& row, const Chart& chart) {
    constexpr std::size_t longest = 190;  // characters
    std::string text = origin_of(table, "accuracy") + ", of which " + row.at("threads") + " used";
    if (chart.diverged.empty()) return text;
    std::string line = "Not drawn, since they diverged: ";
    for (const auto& [label, settings] : chart.diverged) {
        if (line.size() + label.size() + settings.size() > longest) text += "\n" + std::exchange(line, "");
        line.append(label).append(settings).append("; ");
    }
    return text + "\n" + line.substr(0, line.size() - 2);
}

/// A logarithmic axis, a little longer than the values: gnuplot's own ranges are whole decades.
struct Axis {
    double from, to;

    explicit Axis(const std::vector<double>& values)
        : from(0.7 * std::ranges::min(values)), to(1.6 * std::ranges::max(values)) {}
    /// The share of the axis's length at which a value is.
    [[nodiscard]] double at(double value) const { return std::log(value / from) / std::log(to / from); }
    /// An axis of at most two decades may hold no power of ten, and has marks at 1, 2 and 5.
    [[nodiscard]] std::string settings(char name) const {
        std::ostringstream text;
        text << "set " << name << "range [" << from << ':' << to << "]\n";
        if (to > 100 * from) return text.str();
        text << "set " << name << "tics (";
        const char* separator = "";
        for (double decade = std::pow(10, std::floor(std::log10(from))); decade <= to; decade *= 10) {
            for (const double mark : {decade, 2 * decade, 5 * decade})
                if (mark >= from && mark <= to) text << std::exchange(separator, ", ") << mark;
        }
        text << ")\n";
        return text.str();
    }
};

struct Axes {
    Axis cost, error;
};

Axes axes_of(const Chart& chart) {
    std::vector<double> costs, errors;
    for (const Curve& curve : chart.curves) {
        for (const MeasuredSetting& point : curve.points) {
            costs.push_back(point.at.cost);
            errors.push_back(point.at.error);
        }
    }
    for (const auto& [label, value] : chart.levels) errors.push_back(value);
    return {Axis(costs), Axis(errors)};
}

constexpr int width = 1200, height = 720;
constexpr double left = 0.065, right = 0.68, top = 0.93;  // of the plot, as shares of the picture

/// The points of the front whose names do not cover each other, the most accurate first.
std::vector<MeasuredSetting> labelled(const std::vector<MeasuredSetting>& front, const Axes& axes) {
    constexpr double label_width = 130, label_height = 12;  // [pixels]
    const auto x = [&](const MeasuredSetting& m) { return (right - left) * width * axes.cost.at(m.at.cost); };
    const auto y = [&](const MeasuredSetting& m) { return 0.85 * height * axes.error.at(m.at.error); };
    std::vector<MeasuredSetting> kept;
    for (const MeasuredSetting& point : front | std::views::reverse) {
        const bool is_free = std::ranges::all_of(kept, [&](const MeasuredSetting& other) {
            return std::abs(x(point) - x(other)) > label_width ||
                   std::abs(y(point) - y(other)) > label_height;
        });
        if (is_free) kept.push_back(point);
    }
    return kept;
}

std::string settings_of(const Kind& kind, const CsvRow& row, const Chart& chart) {
    const Axes axes = axes_of(chart);
    std::ostringstream text;
    text << "set encoding utf8\nset logscale xy\nset format '%g'\nset border 3 linecolor rgb '#495057'\n"
            "set tics nomirror\nset grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb "
            "'#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'\n"
         << axes.cost.settings('x') << axes.error.settings('y') << "set label 1 "
         << quoted(title_of(kind, row)) << " at screen 0.012, screen 0.965 font ',13' noenhanced\n"
         << "set xlabel 'median time of a frame of 1/60 s [ms]'\nset ylabel " << quoted(kind.axis) << "\n"
         << "set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced\n"
         << "set lmargin at screen " << left << "\nset rmargin at screen " << right
         << "\nset tmargin at screen " << top << '\n';
    if (kind.has_front) {
        const std::vector<MeasuredSetting> front = front_of_chart(chart);
        text << data_block("front", front) << data_block("labelled", labelled(front, axes));
    }
    for (std::size_t c = 0; c < chart.curves.size(); ++c)
        text << data_block("curve" + std::to_string(c), chart.curves[c].points);
    text << data_block("default", chart.defaults);
    return text.str();
}

std::string plot_of(const Kind& kind, const Chart& chart) {
    std::ostringstream text;
    const char* separator = "plot ";
    const auto next = [&]() -> std::ostringstream& {
        text << std::exchange(separator, ", \\\n  ");
        return text;
    };
    if (kind.has_front)
        next() << "$front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'nothing is cheaper "
                  "and better'";
    for (int dash = 2; const auto& [label, value] : chart.levels)
        next() << value << " with lines dashtype " << dash++
               << " linewidth 1.2 linecolor rgb '#495057' title " << quoted(label);
    for (std::size_t c = 0; c < chart.curves.size(); ++c) {
        const Style style = style_of(chart.curves[c].method);
        next() << "$curve" << c << " using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype "
               << style.mark << " linecolor rgb '" << style.colour << "' title "
               << quoted(chart.curves[c].label);
    }
    if (kind.has_front)
        next() << "$labelled using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' "
                  "noenhanced notitle";
    if (!chart.defaults.empty()) {
        next() << "$default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb "
                  "'#000000' title "
                  "'Weft''s default'";
    }
    text << '\n';
    return text.str();
}

}  // namespace

bool is_accuracy_table(const CsvTable& table) {
    return std::ranges::find(table.columns, "truth_1s_mm") != table.columns.end();
}

void draw_accuracy(const CsvTable& table, const std::filesystem::path& folder) {
    std::map<std::string, Rows> scenes;
    for (const CsvRow& row : table.rows) {
        const std::string size = row.at("n") == "0" ? "" : "-" + row.at("n");
        scenes[row.at("scene") + size].push_back(&row);
    }
    for (const auto& [name, rows] : scenes) {
        for (const Kind& kind : kinds()) {
            const Chart chart = chart_of(rows, kind);
            if (chart.curves.empty()) continue;
            const CsvRow& row = described(rows);
            draw_with_gnuplot(folder / ("accuracy-" + name + "-" + kind.file),
                              {width, height, footer_of(table, row, chart)}, settings_of(kind, row, chart),
                              plot_of(kind, chart));
        }
    }
}

}  // namespace weft::study
