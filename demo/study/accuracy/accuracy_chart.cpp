#include "demo/study/accuracy/accuracy_chart.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "demo/study/charts/front.h"
#include "demo/study/charts/gnuplot.h"

namespace weft::study {

namespace {

/// One chart that is drawn of every scene that has the column.
struct Kind {
    std::string file, title, axis, column;
    bool has_front;
    /// Rows of references whose value is drawn as a level, and the level's name.
    std::vector<std::pair<std::string, std::string>> levels;
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        {"a-1s",
         "distance from converged backward Euler after 1 s",
         "RMS distance of particles [mm]",
         "error_a_1s_mm",
         true,
         {{"linearised", "one linearisation, solved exactly"}}},
        {"b-0.5s",
         "distance from the true motion (tiny steps) after 0.5 s",
         "RMS distance of particles [mm]",
         "error_b_0.5s_mm",
         true,
         {{"converged", "backward Euler, converged"}, {"converged-bdf2", "BDF2, converged"}}},
        {"own-1s",
         "distance from the method's own converged step after 1 s",
         "RMS distance of particles [mm]",
         "error_own_1s_mm",
         false,
         {}},
        {"stretch",
         "worst stretch of a thread after 1 s",
         "worst stretch [%]",
         "worst_stretch_percent",
         false,
         {{"fine-time", "the true motion (tiny steps)"}}},
        {"step",
         "distance from the converged step",
         "RMS distance of particles after one step [mm]",
         "error_a_step_mm",
         true,
         {}},
        {"energy",
         "energy left above the converged step",
         "energy gap over that of the inertial start",
         "energy_gap",
         true,
         {}},
    };
    return all;
}

/// How a curve looks: families by colour, members by shade and mark.
struct Style {
    const char* colour;
    int mark;
};

Style style_of(const std::string& method) {
    static const std::map<std::string, Style> styles{
        {"jacobi", {"#d62728", 7}},
        {"jacobi-even", {"#f4a6a6", 6}},
        {"jacobi-tethers", {"#8c1515", 9}},
        {"jacobi-substeps", {"#e8590c", 8}},
        {"chebyshev", {"#f59f00", 5}},
        {"cg", {"#b8860b", 13}},
        {"multilevel-nlcg", {"#1f77b4", 7}},
        {"multilevel-linear", {"#74c0fc", 6}},
        {"multilevel-passes", {"#0b3d91", 5}},
        {"multilevel-substeps", {"#15aabf", 8}},
        {"multilevel-bdf2", {"#2b8a3e", 9}},
        {"multilevel-bdf2-substeps", {"#74b816", 11}},
        {"elements", {"#087f5b", 4}},
        {"xpbd", {"#9c36b5", 7}},
        {"xpbd-iterations", {"#da77f2", 6}},
        {"fibres", {"#e64980", 13}},
        {"fibres-substeps", {"#f783ac", 12}},
        {"symplectic-euler", {"#495057", 15}},
        {"explicit-euler", {"#adb5bd", 14}},
        {"cholesky", {"#000000", 2}},
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
    std::set<std::string> diverged;
};

Chart chart_of(const Rows& rows, const Kind& kind) {
    Chart chart;
    for (const CsvRow* const row : rows) {
        if (row->at("status") == "diverged")
            chart.diverged.insert(row->at("label") + " " + row->at("setting"));
        const auto error = positive(*row, kind.column), cost = positive(*row, "median_ms");
        if (row->at("status") == "reference" && error) {
            for (const auto& [method, text] : kind.levels)
                if (row->at("method") == method) chart.levels.emplace_back(text, *error);
        }
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
                                                           {"tshirt-fine", "T-shirt hung by its neck"},
                                                           {"dress", "Dress hung by its neck"}};
    const auto at = titles.find(row.at("scene"));
    const std::string title = at == titles.end() ? row.at("scene") : at->second;
    if (row.at("n") != "0") return title + ", " + row.at("n") + " × " + row.at("n") + " particles";
    return title + ", " + row.at("particles") + " particles";
}

/// The first row of a method: rows of references have no particles.
const CsvRow& described(const Rows& rows) {
    const auto at =
        std::ranges::find_if(rows, [](const CsvRow* row) { return !row->at("particles").empty(); });
    return at == rows.end() ? *rows.front() : **at;
}

std::string rounded(const std::string& value) {
    const auto parsed = parse_number(value);
    return parsed ? std::to_string(std::llround(*parsed)) : value;
}

std::string caption(const CsvRow& row, const Chart& chart) {
    std::string text = row.at("machine") + ", " + row.at("threads") + " used; commit " + row.at("commit") +
                       "; κ = " + rounded(row.at("kappa")) + "; weft_study accuracy, then weft_study plot";
    if (!chart.diverged.empty()) {
        text += "\nNot drawn, since they diverged:";
        std::string line;
        for (const std::string& what : chart.diverged) {
            if (line.size() > 110) text += std::exchange(line, "") + "\n";
            line += (line.empty() ? " " : "; ") + what;
        }
        text += line;
    }
    return text;
}

/// An axis's range, a little beyond the values: gnuplot's own ranges are whole decades. An axis of at most
/// two decades may hold no power of ten, and has marks at 1, 2 and 5.
std::string range_of(char axis, const std::vector<double>& values) {
    const auto [least, largest] = std::ranges::minmax(values);
    const double from = 0.7 * least, to = 1.6 * largest;
    std::ostringstream text;
    text << "set " << axis << "range [" << from << ':' << to << "]\n";
    if (to > 100 * from) return text.str();
    text << "set " << axis << "tics (";
    const char* separator = "";
    for (double decade = std::pow(10, std::floor(std::log10(from))); decade <= to; decade *= 10) {
        for (const double mark : {decade, 2 * decade, 5 * decade})
            if (mark >= from && mark <= to) text << std::exchange(separator, ", ") << mark;
    }
    text << ")\n";
    return text.str();
}

std::string ranges_of(const Chart& chart) {
    std::vector<double> costs, errors;
    const auto take = [&](const std::vector<MeasuredSetting>& points) {
        for (const MeasuredSetting& point : points) {
            costs.push_back(point.at.cost);
            errors.push_back(point.at.error);
        }
    };
    take(chart.defaults);
    for (const Curve& curve : chart.curves) take(curve.points);
    for (const auto& [label, value] : chart.levels) errors.push_back(value);
    return range_of('x', costs) + range_of('y', errors);
}

std::string settings_of(const Kind& kind, const CsvRow& row, const Chart& chart) {
    std::ostringstream text;
    text << "set encoding utf8\nset logscale xy\nset format '%g'\nset border 3 linecolor rgb '#495057'\n"
            "set tics nomirror\nset grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb "
            "'#dde2e6', "
            "linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'\n"
         << ranges_of(chart) << "set title " << quoted(scene_title(row) + ": " + kind.title)
         << " noenhanced font ',13'\n"
         << "set xlabel 'median time of a frame of 1/60 s [ms]'\nset ylabel " << quoted(kind.axis) << "\n"
         << "set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced\n"
         << "set rmargin 42\nset bmargin " << (chart.diverged.empty() ? 5 : 8) << '\n'
         << "set label 1 " << quoted(caption(row, chart)) << " at screen 0.012, screen "
         << (chart.diverged.empty() ? 0.022 : 0.085) << " font ',8' textcolor rgb '#6c757d' noenhanced\n";
    if (kind.has_front) text << data_block("front", front_of_chart(chart));
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
        next() << "$front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing "
                  "is cheaper and "
                  "better'";
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
        next() << "$front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' "
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
    return std::ranges::find(table.columns, "error_a_1s_mm") != table.columns.end();
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
            draw_with_gnuplot(folder / ("accuracy-" + name + "-" + kind.file), 1200, 760,
                              settings_of(kind, described(rows), chart), plot_of(kind, chart));
        }
    }
}

}  // namespace weft::study
