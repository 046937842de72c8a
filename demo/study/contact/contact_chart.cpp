#include "demo/study/charts/charts.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "demo/study/charts/gnuplot.h"
#include "demo/study/contact/contact_scenes.h"
#include "demo/study/machine.h"

namespace weft::study {

namespace {

constexpr const char* contact_title =
    "Crossings and stretch where cloth meets cloth: the worst of a run, and what is left at its end";
constexpr std::array<const char*, 4> colours{"#7f7f7f", "#1f77b4", "#d62728", "#2ca02c"};  // of the methods

std::vector<std::string> scenes_of(const CsvTable& table) {
    std::vector<std::string> scenes;
    for (const CsvRow& row : table.rows)
        if (std::ranges::find(scenes, row.at("scene")) == scenes.end()) scenes.push_back(row.at("scene"));
    return scenes;
}

/// Lines `peak final line` of one method. Values are drawn at `least` or above, since the axis is
/// logarithmic.
std::string points(const CsvTable& table, const std::vector<std::string>& scenes, std::size_t method,
                   const std::string& peak, const std::string& final, double least) {
    std::ostringstream text;
    for (const CsvRow& row : table.rows) {
        if (row.at("rung") != name_of(self_collision_methods.at(method))) continue;
        const auto line = static_cast<double>(std::ranges::find(scenes, row.at("scene")) - scenes.begin());
        const auto value = [&](const std::string& column) {
            return std::max(least, parse_number(row.at(column)).value_or(least));
        };
        const double aside =
            0.5 * ((static_cast<double>(method) + 0.5) / self_collision_methods.size() - 0.5);
        text << value(peak) << ' ' << value(final) << ' ' << line + aside << '\n';
    }
    return text.str();
}

std::string plot_of(const std::string& block) {
    std::string text = "plot ";
    for (std::size_t r = 0; r < self_collision_methods.size(); ++r) {
        const std::string data = "$" + block + std::to_string(r);
        const std::string colour = " linecolor rgb " + quoted(colours.at(r));
        text += (r > 0 ? ", " : "") + data + " using 2:3:($1-$2):(0) with vectors nohead" + colour +
                " notitle, " + data + " using 1:3 with points pointtype 6" + colour + " title " +
                quoted(std::string(name_of(self_collision_methods.at(r))) + ", peak") + ", " + data +
                " using 2:3 with points pointtype 7" + colour + " title " +
                quoted(std::string(name_of(self_collision_methods.at(r))) + ", final");
    }
    return text + "\n";
}

}  // namespace

void draw_contact(const CsvTable& table, const std::filesystem::path& folder) {
    const std::vector<std::string> scenes = scenes_of(table);
    std::ostringstream settings;
    for (std::size_t r = 0; r < self_collision_methods.size(); ++r) {
        settings << "$pairs" << r << " << EOD\n"
                 << points(table, scenes, r, "crossings_peak", "crossings_final", 0.5) << "EOD\n"
                 << "$edges" << r << " << EOD\n"
                 << points(table, scenes, r, "stretch_worst", "stretch_final", 1) << "EOD\n";
    }
    const int height = 170 + 24 * static_cast<int>(scenes.size());
    const auto share = [&](int pixels) { return 1 - static_cast<double>(pixels) / height; };
    settings << "set yrange [" << static_cast<double>(scenes.size()) - 0.5 << ":-0.5]\nset grid\n"
             << "set logscale x\nset tmargin at screen " << share(84) << "\nset key at screen 0.5, screen "
             << share(30) << " center top horizontal\nset label 1 " << quoted(contact_title)
             << " at screen 0.012, screen " << share(16) << " font ',13' noenhanced\nset ytics (";
    for (std::size_t i = 0; i < scenes.size(); ++i)
        settings << (i > 0 ? ", " : "") << quoted(scenes[i]) << ' ' << i;
    settings << ")\n";
    const std::string plot = "set multiplot layout 1,2\nset key\nset xrange [0.4:*]\nset xlabel " +
                             quoted("crossing pairs of triangles, none at 0.5") + "\n" + plot_of("pairs") +
                             "unset key\nset xrange [0.98:*]\nset xlabel " +
                             quoted("longest edge over its length at rest") + "\n" + plot_of("edges") +
                             "unset multiplot\n";
    draw_with_gnuplot(folder / "contact", {1300, height, origin_of(table, "contact")}, settings.str(), plot);
}

}  // namespace weft::study
