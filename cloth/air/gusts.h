#pragma once
// Gusts: a wind that differs from place to place and from moment to moment, the same at every run.

#include <array>
#include <cstdint>
#include <span>

#include "engine/threads/parallel_blocks.h"
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

    /// Computes velocities of the air at points [m/s], w 0. Both are in AlignedBuffers.
    void sample(Parallel& parallel, std::span<const Vec4> points, std::span<Vec4> velocities) const;

    /// Lattice values repeat after this many cells, so that coordinates stay small floats however long the
    /// wind has blown.
    static constexpr int period = 256;
    /// One octave of noise: lattice coordinates are point * scale + offset.
    struct Octave {
        float scale;
        Vector3 offset;
        std::uint32_t seed;
    };
    Vector3 mean;
    float amplitude;  ///< root mean square of the gusts [m/s]
    std::array<Octave, 2> octaves;
};

}  // namespace weft
