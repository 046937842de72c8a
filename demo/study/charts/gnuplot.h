#pragma once
// Pictures by gnuplot.

#include <filesystem>
#include <string>

namespace weft::study {

/// In single quotes, where gnuplot doubles those that belong to the text.
[[nodiscard]] std::string quoted(const std::string& text);

/// Writes `stem`.gnuplot, whose `plot` is drawn as `stem`.svg and `stem`.png, and runs it. Throws
/// std::runtime_error if gnuplot fails.
void draw_with_gnuplot(const std::filesystem::path& stem, int width, int height, const std::string& settings,
                       const std::string& plot);

}  // namespace weft::study
