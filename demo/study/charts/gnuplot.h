#pragma once
// Pictures by gnuplot.

#include <filesystem>
#include <sstream>
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

/// A picture of boxes and texts at places in pixels, drawn by gnuplot as SVG and PNG.
class Canvas {
  public:
    enum class Align { left, centre, right };

    /// x to the right and y downwards, from the upper left corner.
    Canvas(int width, int height) : width_(width), height_(height) {}

    /// Colours as 0xrrggbb.
    void box(double x, double y, double width, double height, unsigned colour);
    void text(double x, double y, const std::string& text, int size, Align align = Align::left,
              unsigned colour = 0x222222, bool bold = false);

    /// Draws `stem`.svg and `stem`.png with small lines below. Throws std::runtime_error if gnuplot fails.
    void draw(const std::filesystem::path& stem, const std::string& footer) const;

  private:
    int width_, height_, text_count_ = 0;
    std::ostringstream boxes_, texts_;
};

}  // namespace weft::study
