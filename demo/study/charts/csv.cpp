#include "demo/study/charts/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace weft::study {

namespace {

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields;
    std::string field;
    std::istringstream stream(line);
    while (std::getline(stream, field, ',')) fields.push_back(field);
    if (line.empty() || line.back() == ',') fields.emplace_back();
    return fields;
}

std::string line_of(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) {
        if (field.find_first_of(",\"\n\r") != std::string::npos)
            throw std::logic_error("\"" + field + "\" does not fit a field of the table");
        line += (&field == fields.data() ? "" : ",") + field;
    }
    return line + "\n";
}

/// The whole lines of a file: text after the last line break was cut short by a stop.
std::vector<std::string> whole_lines(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error(file.string() + " cannot be read");
    std::vector<std::string> lines;
    std::string line;
    while (std::getline(in, line) && !in.eof()) lines.push_back(line);
    return lines;
}

void write(const std::filesystem::path& file, const std::string& text, std::ios::openmode mode) {
    std::ofstream out(file, std::ios::binary | mode);
    out << text << std::flush;
    if (!out) throw std::runtime_error(file.string() + " cannot be written");
}

}  // namespace

CsvTable read_csv(const std::filesystem::path& file) {
    CsvTable table;
    for (const std::string& line : whole_lines(file)) {
        std::vector<std::string> fields = fields_of(line);
        if (table.columns.empty()) {
            table.columns = std::move(fields);
            continue;
        }
        if (fields.size() != table.columns.size())
            throw std::runtime_error(file.string() + ": a row has " + std::to_string(fields.size()) +
                                     " fields, the header " + std::to_string(table.columns.size()));
        CsvRow row;
        for (std::size_t c = 0; c < fields.size(); ++c) row[table.columns[c]] = fields[c];
        table.rows.push_back(std::move(row));
    }
    return table;
}

CsvWriter::CsvWriter(std::filesystem::path file, std::vector<std::string> columns, bool resume)
    : file_(std::move(file)) {
    if (file_.has_parent_path()) std::filesystem::create_directories(file_.parent_path());
    if (resume && std::filesystem::exists(file_)) table_ = read_csv(file_);
    if (!table_.columns.empty() && table_.columns != columns)
        throw std::runtime_error(file_.string() +
                                 " has other columns; name another file, or leave --resume out");
    table_.columns = std::move(columns);
    write_all();  // drops a line that was cut short
}

// Writes beside the file first, so that a stop here leaves a whole table.
void CsvWriter::write_all() const {
    std::string text = line_of(table_.columns);
    for (const CsvRow& row : table_.rows) text += text_of(row);
    const std::filesystem::path beside = file_.string() + ".part";
    write(beside, text, std::ios::trunc);
    std::filesystem::rename(beside, file_);
}

const CsvRow* CsvWriter::find(const CsvRow& row, const std::vector<std::string>& keys) const {
    const auto equal = [&](const CsvRow& other) {
        return std::ranges::all_of(keys,
                                   [&](const std::string& key) { return other.at(key) == row.at(key); });
    };
    const auto at = std::ranges::find_if(table_.rows, equal);
    return at == table_.rows.end() ? nullptr : &*at;
}

void CsvWriter::append(const CsvRow& row) {
    CsvRow complete = whole(row);
    write(file_, text_of(complete), std::ios::app);
    table_.rows.push_back(std::move(complete));
}

void CsvWriter::replace(const CsvRow& row, const std::vector<std::string>& keys) {
    const CsvRow* const old = find(row, keys);
    if (old == nullptr) return append(row);
    table_.rows[static_cast<std::size_t>(old - table_.rows.data())] = whole(row);
    write_all();
}

CsvRow CsvWriter::whole(const CsvRow& row) const {
    CsvRow result;
    for (const std::string& column : table_.columns) {
        const auto at = row.find(column);
        result[column] = at == row.end() ? "" : at->second;
    }
    return result;
}

std::string CsvWriter::text_of(const CsvRow& row) const {
    std::vector<std::string> fields;
    for (const std::string& column : table_.columns) fields.push_back(row.at(column));
    return line_of(fields);
}

std::string number(double value) {
    if (!std::isfinite(value)) return {};
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::optional<double> parse_number(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return {};
    return value;
}

}  // namespace weft::study
