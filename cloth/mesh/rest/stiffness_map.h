#pragma once
// The factors of Map::stiffness for triangles and cells.

#include <array>
#include <cstdint>

#include "cloth/mesh/cook.h"

namespace weft {

/// Mean factor of the membrane's stiffness at these particles.
template <std::size_t corners>
[[nodiscard]] double stiffness_at(const ClothModel& model,
                                  const std::array<std::uint32_t, corners>& particles) {
    if (model.stiffness.size() == 0) return 1;
    double sum = 0;
    for (const std::uint32_t i : particles) sum += static_cast<double>(model.stiffness[i]);
    return sum / static_cast<double>(corners);
}

/// The same for the cell whose near left corner is `near`.
[[nodiscard]] inline double stiffness_of_cell(const ClothModel& model, std::uint32_t near) {
    return stiffness_at<4>(model, {near, near + 1, near + model.columns, near + model.columns + 1});
}

}  // namespace weft
