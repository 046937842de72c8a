#pragma once
// Tables as comma-separated values: a header, then rows that are appended one at a time, so that a run that
// was stopped can go on where it was.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace weft::study {

/// Column name -> text. Texts hold no comma, quote or line break.
using CsvRow = std::map<std::string, std::string>;

struct CsvTable {
    std::vector<std::string> columns;
    std::vector<CsvRow> rows;
};

/// Throws std::runtime_error for a file that cannot be read or whose rows do not fit its header. A last line
/// that was cut short is left out.
[[nodiscard]] CsvTable read_csv(const std::filesystem::path& file);

class CsvWriter {
  public:
    /// Starts the file anew, or keeps its rows if `resume`. Throws std::runtime_error if it cannot be
    /// written, or has other columns.
    CsvWriter(std::filesystem::path file, std::vector<std::string> columns, bool resume);

    /// The row, read or appended, whose `keys` columns equal those of `row`; null if there is none.
    [[nodiscard]] const CsvRow* find(const CsvRow& row, const std::vector<std::string>& keys) const;
    /// Appends a row; it is on the disk when this returns. Columns that `row` lacks stay empty.
    void append(const CsvRow& row);
    /// Puts the row in place of the one that equals it in `keys`; appends it if there is none.
    void replace(const CsvRow& row, const std::vector<std::string>& keys);

  private:
    void write_all() const;
    /// The row with empty texts for the columns that it lacks.
    [[nodiscard]] CsvRow whole(const CsvRow& row) const;
    [[nodiscard]] std::string text_of(const CsvRow& row) const;

    std::filesystem::path file_;
    CsvTable table_;
};

/// The value with six digits; empty if it is not finite.
[[nodiscard]] std::string number(double value);
/// The number of a field; none if it is empty or no number.
[[nodiscard]] std::optional<double> parse_number(const std::string& text);

}  // namespace weft::study
