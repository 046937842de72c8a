#include "demo/study/charts/charts.h"
#include "demo/study/stability/stability_causes.h"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "demo/study/charts/gnuplot.h"
#include "demo/study/machine.h"
#include "demo/study/stability/stability_cell.h"

namespace weft::study {

namespace {

using Rows = std::vector<const CsvRow*>;

// Colours of the verdicts, which also differ in lightness, for colour-blind eyes.
constexpr std::array<unsigned, verdict_count> colours{0x58b08a, 0xf6d36b, 0xc6453f, 0x2b1a33};
constexpr unsigned grey = 0x666666;

/// Maps in a row, and lengths in pixels.
constexpr int map_columns = 5;
constexpr double map_width = 208, cell_height = 26, map_gap = 16, left = 74, top = 84, map_top = 24,
                 row_gap = 22, legend_line = 21;

/// A column's different values, in order of first appearance.
std::vector<std::string> values(const Rows& rows, const std::string& column) {
    std::vector<std::string> found;
    for (const CsvRow* row : rows) {
        const std::string& value = row->at(column);
        if (std::ranges::find(found, value) == found.end()) found.push_back(value);
    }
    return found;
}

/// These values as numbers, descending: from the upper edge of a map, and from the shortest step.
std::vector<double> ticks(const Rows& rows, const std::string& column) {
    std::vector<double> found;
    for (const std::string& value : values(rows, column)) found.push_back(parse_number(value).value());
    std::ranges::sort(found, std::greater<>{});
    return found;
}

Rows rows_with(const Rows& rows, const std::string& column, const std::string& value) {
    Rows found;
    std::ranges::copy_if(rows, std::back_inserter(found),
                         [&](const CsvRow* row) { return row->at(column) == value; });
    return found;
}

/// E, S and H for the tolerances that a cell broke.
std::string letters(const std::string& broken) {
    std::string text;
    for (const auto& [name, letter] : {std::pair{"energy", 'E'}, {"stretch", 'S'}, {"height", 'H'}})
        if (broken.find(name) != std::string::npos) text += letter;
    return text;
}

/// All maps of one start.
class StartMaps {
  public:
    StartMaps(const Rows& rows, const std::string& start)
        : rows_(rows),
          methods_(values(rows, "method")),
          hz_(ticks(rows, "hz")),
          stiffness_(ticks(rows, "stiffness")),
          cell_width_(map_width / static_cast<double>(hz_.size())),
          map_height_(cell_height * static_cast<double>(stiffness_.size())),
          canvas_(static_cast<int>(left + map_columns * (map_width + map_gap)),
                  static_cast<int>(legend_top() + 8 * legend_line + 6)) {
        write_title(start);
        for (std::size_t map = 0; map < methods_.size(); ++map) write_map(map);
        write_legend(start);
    }

    void draw(const std::filesystem::path& stem, const std::string& footer) const {
        canvas_.draw(stem, footer);
    }

  private:
    using Align = Canvas::Align;

    [[nodiscard]] std::size_t map_rows() const { return (methods_.size() + map_columns - 1) / map_columns; }
    [[nodiscard]] double row_height() const { return map_top + map_height_ + row_gap; }
    [[nodiscard]] double legend_top() const {
        return top + static_cast<double>(map_rows()) * row_height() + 34;
    }

    void write_title(const std::string& start) {
        const CsvRow& row = *rows_.front();
        canvas_.text(left, 24, "Where methods fail, from a " + start + " start", 15, Align::left, 0x111111,
                     true);
        canvas_.text(left, 48,
                     "A sheet of " + row.at("per_side") + " x " + row.at("per_side") +
                         " particles, 1 m, 0.2 kg/m², hung by two corners, " + row.at("seconds") +
                         " s. Across: the frame's step [s]. Upwards: stiffness, times 400 N/m.",
                     10, Align::left, grey);
    }

    void write_map(std::size_t map) {
        const double x = left + static_cast<double>(map % map_columns) * (map_width + map_gap);
        const double y = top + static_cast<double>(map / map_columns) * row_height() + map_top;
        const Rows cells = rows_with(rows_, "method", methods_[map]);
        canvas_.text(x, y - 12, cells.front()->at("label"), 10, Align::left, 0x111111,
                     cells.front()->at("default") == "yes");
        for (const CsvRow* cell : cells) write_cell(x, y, *cell);
        if (map % map_columns == 0) write_stiffnesses(x, y);
        if (map + map_columns >= methods_.size()) write_steps(x, y + map_height_);
    }

    void write_cell(double map_x, double map_y, const CsvRow& cell) {
        const auto at = [&](const std::vector<double>& ticks, const char* column) {
            const double value = parse_number(cell.at(column)).value();
            return static_cast<double>(std::ranges::find(ticks, value) - ticks.begin());
        };
        const double x = map_x + cell_width_ * at(hz_, "hz"),
                     y = map_y + cell_height * at(stiffness_, "stiffness");
        const Verdict verdict = verdict_of(cell.at("verdict"));
        canvas_.box(x + 1, y + 1, cell_width_ - 2, cell_height - 2,
                    colours[static_cast<std::size_t>(verdict)]);
        if (verdict == Verdict::wrong)
            canvas_.text(x + cell_width_ / 2, y + cell_height / 2, letters(cell.at("broken")), 9,
                         Align::centre, 0x5c4600);
    }

    void write_stiffnesses(double x, double y) {
        for (std::size_t i = 0; i < stiffness_.size(); ++i) {
            canvas_.text(x - 6, y + cell_height * (static_cast<double>(i) + 0.5),
                         "x " + number(stiffness_[i]), 9, Align::right, grey);
        }
    }

    void write_steps(double x, double y) {
        for (std::size_t i = 0; i < hz_.size(); ++i) {
            canvas_.text(x + cell_width_ * (static_cast<double>(i) + 0.5), y + 12, "1/" + number(hz_[i]), 9,
                         Align::centre, grey);
        }
    }

    void write_legend(const std::string& start) {
        const Tolerance tolerance = tolerance_of(start_named(start));
        write_entry(0, Verdict::stable, "stable: none of what follows");
        write_entry(1, Verdict::wrong, "bounded, but wrong, by one or more of these:");
        write_line(2, "E  energy rose above the start's by more than " + percent(tolerance.energy_rise) +
                          " of what the start has above the still hang");
        write_line(3, "S  at the end the mean stretch is off the still hang's by more than " +
                          percent(tolerance.stretch));
        write_line(4,
                   std::isfinite(tolerance.height)
                       ? "H  at the end the centre of mass is off the still hang's by more than " +
                             number(100 * tolerance.height) + " cm"
                       : "(the height is not judged: without collisions, collapsed cloth ends in a tangle)");
        write_entry(5, Verdict::diverged,
                    "diverged: a particle went beyond 100 km, or at the end the mean stretch is above " +
                        percent(torn_stretch) +
                        " and the energy above the start's by all that it had to lose");
        write_entry(6, Verdict::not_a_number, "not a number, from a state that was still near and finite");
    }

    void write_entry(int line, Verdict verdict, const std::string& text) {
        canvas_.box(left, legend_top() + legend_line * line, 24, 15,
                    colours[static_cast<std::size_t>(verdict)]);
        write_line(line, text);
    }
    void write_line(int line, const std::string& text) {
        canvas_.text(left + 34, legend_top() + legend_line * line + 8, text, 10);
    }
    static std::string percent(double part) { return number(100 * part) + " %"; }

    const Rows& rows_;
    std::vector<std::string> methods_;
    std::vector<double> hz_, stiffness_;
    double cell_width_, map_height_;
    Canvas canvas_;
};

}  // namespace

bool is_stability_table(const CsvTable& table) {
    return std::ranges::find(table.columns, "verdict") != table.columns.end();
}

void draw_stability(const CsvTable& table, const std::filesystem::path& folder) {
    Rows all;
    for (const CsvRow& row : table.rows) all.push_back(&row);
    std::filesystem::create_directories(folder);
    for (const std::string& start : values(all, "start")) {
        const Rows rows = rows_with(all, "start", start);
        StartMaps(rows, start).draw(folder / ("stability-" + start), origin_of(table, "stability"));
    }
    write_causes(table, folder);
}

}  // namespace weft::study
