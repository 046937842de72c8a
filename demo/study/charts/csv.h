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

    /// The row whose `keys` columns are equal to those of `row`, from before or since; null if there is none.
    [[nodiscard]] const CsvRow* find(const CsvRow& row, const std::vector<std::string>& keys) const;
    /// Columns that `row` lacks stay empty. On the disk when this returns.
    void append(const CsvRow& row);
    /// The row in place of the one that is equal to it in `keys`; appended if there is none.
    void replace(const CsvRow& row, const std::vector<std::string>& keys);

  private:
    void write_all() const;
    /// With empty texts for what it lacks.
    [[nodiscard]] CsvRow whole(const CsvRow& row) const;
    [[nodiscard]] std::string text_of(const CsvRow& row) const;

    std::filesystem::path file_;
    CsvTable table_;
};

/// Six digits, or empty for what is not finite.
[[nodiscard]] std::string number(double value);
/// The number of a field; none if it is empty or no number.
[[nodiscard]] std::optional<double> parse_number(const std::string& text);

}  // namespace weft::study
