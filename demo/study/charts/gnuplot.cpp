#include "demo/study/charts/gnuplot.h"

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

void draw_with_gnuplot(const std::filesystem::path& stem, int width, int height, const std::string& settings,
                       const std::string& plot) {
    const std::filesystem::path folder = stem.has_parent_path() ? stem.parent_path() : ".";
    const std::string name = stem.filename().string();
    const std::string size = std::to_string(width) + "," + std::to_string(height);
    std::filesystem::create_directories(folder);
    const std::string script = stem.string() + ".gnuplot";
    std::ofstream out(script);
    out << settings << "set terminal svg size " << size << " font 'DejaVu Sans,13' background rgb 'white'\n"
        << "set output " << quoted(name + ".svg") << '\n'
        << plot << "set terminal pngcairo size " << size << " font 'DejaVu Sans,10' background rgb 'white'\n"
        << "set output " << quoted(name + ".png") << '\n'
        << plot;
    out.close();
    const std::string command = "cd '" + folder.string() + "' && gnuplot '" + name + ".gnuplot'";
    if (!out || std::system(command.c_str()) != 0) throw std::runtime_error(script + " could not be drawn");
}

}  // namespace weft::study
