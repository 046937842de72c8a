#pragma once
// How far a cloth is stretched; for the study and for benchmarks.

#include <algorithm>
#include <cstdint>
#include <Eigen/Core>
#include <span>

#include "cloth/mesh/cook.h"

namespace weft::study {

/// Worst and mean length over rest length of the structural springs.
struct Stretch {
    double worst, mean;
};
/// `positions`: of all particles [m].
[[nodiscard]] inline Stretch structural_stretch(const ClothModel& model,
                                                std::span<const Eigen::Vector3d> positions) {
    Stretch stretch{0, 0};
    std::size_t springs = 0;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            if (model.kinds[e] != SpringKind::structural) continue;
            const double length = (positions[model.neighbours[e]] - positions[i]).norm();
            const double ratio = length / static_cast<double>(model.rest_lengths[e]);
            stretch.worst = std::max(stretch.worst, ratio);
            stretch.mean += ratio;
            ++springs;
        }
    }
    if (springs > 0) stretch.mean /= static_cast<double>(springs);
    return stretch;
}

}  // namespace weft::study
