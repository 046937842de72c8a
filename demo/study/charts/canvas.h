#pragma once
// A picture of boxes and texts at places in pixels, drawn by gnuplot as SVG and PNG.

#include <filesystem>
#include <sstream>
#include <string>

namespace weft::study {

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
