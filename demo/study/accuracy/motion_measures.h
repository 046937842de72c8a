#pragma once
// Measures of a time scheme: energy and speed of a swing, and the time until cloth rests.

#include <span>
#include <vector>

#include "demo/study/accuracy/energy.h"
#include "demo/study/run.h"

namespace weft::study {

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
