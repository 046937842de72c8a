#include "demo/study/charts/canvas.h"

#include <cstdio>

#include "demo/study/charts/gnuplot.h"

namespace weft::study {

namespace {

std::string hexadecimal(unsigned colour) {
    char text[8];
    std::snprintf(text, sizeof text, "#%06x", colour);
    return text;
}

}  // namespace

void Canvas::box(double x, double y, double width, double height, unsigned colour) {
    boxes_ << "set object rectangle from " << x << ',' << height_ - y << " to " << x + width << ','
           << height_ - y - height << " fillcolor rgb '" << hexadecimal(colour)
           << "' fillstyle solid noborder\n";
}

// Sizes are points for PNG; SVG has pixels, a third smaller.
void Canvas::text(double x, double y, const std::string& text, int size, Align align, unsigned colour,
                  bool bold) {
    const char* const side = align == Align::left ? "left" : align == Align::right ? "right" : "center";
    texts_ << "set label " << ++text_count_ << ' ' << quoted(bold ? "{/:Bold " + text + "}" : text) << " at "
           << x << ',' << height_ - y << ' ' << side << " font sprintf(',%g', scale * " << size
           << ") textcolor rgb " << quoted(hexadecimal(colour)) << (bold ? "" : " noenhanced") << " front\n";
}

void Canvas::draw(const std::filesystem::path& stem, const std::string& footer) const {
    std::ostringstream settings;
    settings << "set encoding utf8\nunset border\nunset tics\nunset key\nset margins 0,0,0,0\nset xrange [0:"
             << width_ << "]\nset yrange [0:" << height_ << "]\n"
             << boxes_.str();
    draw_with_gnuplot(stem, {width_, height_, footer, 0}, settings.str(),
                      "scale = GPVAL_TERM eq 'svg' ? 4.0 / 3 : 1\n" + texts_.str() + "plot NaN\n");
}

}  // namespace weft::study
