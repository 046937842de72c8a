#include "demo/study/charts/gnuplot.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace weft::study {

std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'')
            result += "''";
        else if (c == '\n')
            result += R"('."\n".')";  // gnuplot's strings end with their line
        else
            result += c;
    }
    return result + "'";
}

void draw_with_gnuplot(const std::filesystem::path& stem, const Picture& picture, const std::string& settings,
                       const std::string& plot) {
    constexpr int line_height = 14;  // of the footer [pixels]
    const auto lines = std::ranges::count(picture.footer, '\n') + (picture.footer.empty() ? 0 : 1);
    const int footer = line_height * static_cast<int>(lines) + 8, height = picture.height + footer;
    const auto share = [&](int pixels) { return static_cast<double>(pixels) / height; };

    const std::filesystem::path folder = stem.has_parent_path() ? stem.parent_path() : ".";
    const std::string name = stem.filename().string();
    const std::string size = std::to_string(picture.width) + "," + std::to_string(height);
    std::filesystem::create_directories(folder);
    const std::string script = stem.string() + ".gnuplot";
    std::ofstream out(script);
    out << settings << "set bmargin at screen " << share(footer + picture.below_plot) << "\nset label 1000 "
        << quoted(picture.footer) << " at screen 0.012, screen " << share(footer - line_height / 2)
        << " font ',8' textcolor rgb '#6c757d' noenhanced\n"
        << "set terminal svg size " << size << " font 'DejaVu Sans,13' background rgb 'white'\n"
        << "set output " << quoted(name + ".svg") << '\n'
        << plot << "set terminal pngcairo size " << size << " font 'DejaVu Sans,10' background rgb 'white'\n"
        << "set output " << quoted(name + ".png") << '\n'
        << plot;
    out.close();
    const std::string command = "cd '" + folder.string() + "' && gnuplot '" + name + ".gnuplot'";
    if (!out || std::system(command.c_str()) != 0) throw std::runtime_error(script + " could not be drawn");
    std::filesystem::remove(script);
}

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
