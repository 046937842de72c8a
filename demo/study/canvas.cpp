#include "demo/study/canvas.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace weft::study {

namespace {

std::string hexadecimal(unsigned colour) {
    char text[8];
    std::snprintf(text, sizeof text, "#%06x", colour);
    return text;
}

/// In single quotes, where gnuplot doubles those that belong to the text.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
    return result + "'";
}

}  // namespace

void Canvas::box(double x, double y, double width, double height, unsigned colour) {
    boxes_ << "set object rectangle from " << x << ',' << height_ - y << " to " << x + width << ','
           << height_ - y - height << " fillcolor rgb '" << hexadecimal(colour)
           << "' fillstyle solid noborder\n";
}

void Canvas::text(double x, double y, const std::string& text, int size, Align align, unsigned colour,
                  bool bold) {
    const char* const side = align == Align::left ? "left" : align == Align::right ? "right" : "center";
    texts_ << "set label " << quoted(bold ? "{/:Bold " + text + "}" : text) << " at " << x << ','
           << height_ - y << ' ' << side << " font '," << size << "' textcolor rgb '" << hexadecimal(colour)
           << "'" << (bold ? "" : " noenhanced") << " front\n";
}

void Canvas::draw(const std::filesystem::path& stem) const {
    const std::string script = stem.string() + ".gnuplot";
    std::ofstream out(script);
    out << "set encoding utf8\nunset border\nunset tics\nunset key\nset margins 0,0,0,0\nset xrange [0:"
        << width_ << "]\nset yrange [0:" << height_ << "]\n"
        << boxes_.str() << texts_.str() << "set output " << quoted(stem.filename().string() + ".svg")
        << "\nset terminal svg size " << width_ << ',' << height_
        << " font 'DejaVu Sans,12' background rgb 'white'\nplot NaN\nset output "
        << quoted(stem.filename().string() + ".png") << "\nset terminal pngcairo size " << width_ << ','
        << height_ << " font 'DejaVu Sans,10' background rgb 'white'\nplot NaN\n";
    out.close();
    const std::string folder = stem.has_parent_path() ? stem.parent_path().string() : ".";
    const std::string command = "cd '" + folder + "' && gnuplot '" + stem.filename().string() + ".gnuplot'";
    if (!out || std::system(command.c_str()) != 0) throw std::runtime_error(script + " could not be drawn");
}

}  // namespace weft::study
