#pragma once
// Pictures by gnuplot.

#include <filesystem>
#include <string>

namespace weft::study {

/// The text as a gnuplot string in single quotes; quotes inside it are doubled.
[[nodiscard]] std::string quoted(const std::string& text);

/// A picture of a given size [pixels], and the small grey lines below it, which make it taller.
struct Picture {
    int width, height;
    std::string footer;
    int below_plot = 50;  ///< pixels of the axis and its label, between the plot and the footer
};

/// Draws `plot` as `stem`.svg and `stem`.png. Throws std::runtime_error if gnuplot fails, and leaves its
/// script beside the pictures.
void draw_with_gnuplot(const std::filesystem::path& stem, const Picture& picture, const std::string& settings,
                       const std::string& plot);

}  // namespace weft::study
