#pragma once
// Pictures by gnuplot.

#include <filesystem>
#include <string>

namespace weft::study {

/// The text as a gnuplot string in single quotes; quotes inside it are doubled.
[[nodiscard]] std::string quoted(const std::string& text);

/// Writes `stem`.gnuplot, whose `plot` is drawn as `stem`.svg and `stem`.png, and runs it. Throws
/// std::runtime_error if gnuplot fails.
void draw_with_gnuplot(const std::filesystem::path& stem, int width, int height, const std::string& settings,
                       const std::string& plot);

}  // namespace weft::study
