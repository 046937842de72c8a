#pragma once
// Contact by scenes and rungs as a picture, drawn by gnuplot.

#include <filesystem>

#include "demo/study/charts/csv.h"

namespace weft::study {

/// contact.svg and .png: crossing pairs and the longest edge, peak and final, a line for each scene and a
/// colour for each method. Throws std::runtime_error if gnuplot fails.
void draw_contact(const CsvTable& table, const std::filesystem::path& folder);

}  // namespace weft::study
