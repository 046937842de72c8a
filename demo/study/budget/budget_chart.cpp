#include "demo/study/charts/charts.h"

#include <algorithm>
#include <sstream>
#include <string>

#include "demo/study/charts/gnuplot.h"
#include "demo/study/machine.h"

namespace weft::study {

namespace {

/// Lines `mean p99 error name` of one kind.
std::string points_of(const CsvTable& table, const std::string& kind) {
    std::ostringstream text;
    for (const CsvRow& row : table.rows)
        if (row.at("kind") == kind)
            text << row.at("mean_ms") << ' ' << row.at("p99_ms") << ' ' << row.at("off_mrad") << " \""
                 << row.at("name") << "\"\n";
    return text.str();
}

}  // namespace

bool is_budget_table(const CsvTable& table) {
    return std::ranges::find(table.columns, "off_mrad") != table.columns.end();
}

void draw_budget(const CsvTable& table, const std::filesystem::path& folder) {
    std::ostringstream settings;
    settings << "$fixed << EOD\n"
             << points_of(table, "fixed") << "EOD\n$budget << EOD\n"
             << points_of(table, "budget") << "EOD\n"
             << "set title " << quoted("Fifty curtains in gusts round a camera that turns, on one thread")
             << '\n'
             << "set xlabel " << quoted("a step, mean and 99th percentile [ms of the processor]") << '\n'
             << "set ylabel " << quoted("as seen, off the cloth as it is set, rms [mrad]") << '\n'
             << "set yrange [-4:*]\nset xrange [0:*]\nset offsets graph 0, graph 0.12, graph 0.05, 0\nset "
                "grid\nset key top right\n";
    std::string plot = "plot ";
    for (const auto& [block, colour, title, label] :
         {std::tuple("$fixed", "#7f7f7f", "one setting for all", "left offset 0.5,-0.9"),
          {"$budget", "#d62728", "a budget of the time of 3 passes", "center offset 0,0.8"}}) {
        const std::string style = " linecolor rgb " + quoted(colour);
        plot += std::string(plot.size() > 5 ? ", " : "") + block +
                " using 1:3:($2-$1):(0) with vectors nohead" + style + " notitle, " + block +
                " using 1:3 with points pointtype 7" + style + " title " + quoted(title) + ", " + block +
                " using 1:3:4 with labels " + label + " font ',8' notitle";
    }
    draw_with_gnuplot(folder / "budget", {900, 560, origin_of(table, "budget")}, settings.str(), plot + "\n");
}

}  // namespace weft::study
