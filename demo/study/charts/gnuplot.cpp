#include "demo/study/charts/gnuplot.h"

#include <algorithm>
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

}  // namespace weft::study
