#pragma once
// Measures of motion in double precision: energy, stretch, and the speed and the rest of a swing.

#include <algorithm>
#include <cstdint>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "cloth/instance/cloth.h"
#include "cloth/mesh/cook.h"
#include "demo/study/run.h"

namespace weft::study {

struct Energy {
    double kinetic = 0, elastic = 0, gravity = 0;  ///< [J]; gravity's is 0 at y = 0
    [[nodiscard]] double total() const { return kinetic + elastic + gravity; }
};

[[nodiscard]] Energy energy_of(const Cloth& cloth, const Vec3& gravity);

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

/// A sheet of 1 m and 0.2 kg/m^2 that is held by one side and let go horizontal, with the bump of
/// hung_sheet(), in a vacuum. In truth only its own damping takes energy.
[[nodiscard]] StudyScene swinging_sheet(std::uint32_t per_side);

struct Swing {
    double energy = 0;  ///< kinetic, elastic and of gravity, 0 where it started [J]
    double speed = 0;   ///< rms over the second half of the time and all particles [m/s]
};
/// The swing by one method, after `seconds`.
[[nodiscard]] Swing swing(StudyScene scene, const MethodPoint& point, int hz, double seconds, int threads);
/// The swing in truth: by the fine steps of FineTime.
[[nodiscard]] Swing true_swing(StudyScene scene, int hz, double seconds, int threads);
/// Energy lost, over what a swinging sheet loses until it hangs: mass times gravity times half its length.
[[nodiscard]] double energy_lost(const StudyScene& scene, const Swing& swing);

/// The time from which on all speeds are below the limit [s]; infinity if the last one is not. speeds[k] is
/// at (k + 1) frame.
[[nodiscard]] double time_to_rest(std::span<const double> speeds, double frame, double limit);
/// Peak speed after each frame of `seconds` seconds [m/s].
[[nodiscard]] std::vector<double> peak_speeds(const StudyScene& scene, const MethodPoint& point,
                                              double seconds, int threads);

}  // namespace weft::study
