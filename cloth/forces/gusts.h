#pragma once
// Gusts: a wind that differs from place to place and from moment to moment, the same at every run.

#include <array>
#include <cstdint>

#include "engine/vector.h"
#include "weft/settings.h"

namespace weft {

/// The air's velocity everywhere at one moment: the mean wind plus eddies, which the mean wind carries along
/// (G. I. Taylor 1938, "The spectrum of turbulence": frozen turbulence) while they slowly rise through one
/// another.
class WindField {
  public:
    /// `carried`: the path that the mean wind has covered since the start [m], in double so that it stays
    /// smooth for days. `time` [s].
    WindField(const Wind& wind, const std::array<double, 3>& carried, double time);

    /// Velocity of the air at a point [m/s].
    [[nodiscard]] Vector3 velocity(const Vector3& point) const {
        return still_ ? mean_ : Vector3(mean_ + amplitude_ * eddies(point));
    }

  private:
    /// Gust velocity over the gusts' root mean square; each component has variance 1 and mean 0.
    [[nodiscard]] Vector3 eddies(const Vector3& point) const;

    /// One octave of noise: lattice coordinates are point * scale + offset.
    struct Octave {
        float scale;
        Vector3 offset;
        std::uint32_t seed;
    };
    Vector3 mean_;
    float amplitude_;  ///< [m/s]
    bool still_;       ///< no gusts
    std::array<Octave, 2> octaves_;
};

}  // namespace weft
