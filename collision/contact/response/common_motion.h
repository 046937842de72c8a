#pragma once
// The motion that a group's particles have in common. It makes nothing cross, so only the rest of their
// motion ever has to be cut.
//
// Proof: an invertible affine map takes a state without crossings to one without, because it is one-to-one
// and takes straight edges and flat triangles to such. If y = x + tau E is free of crossings,
// A (y - c) + c + t is so too, whatever the tau of each particle. With
//     F = D - t - (A - I)(x - c)   [what is left of the displacement D],   E = A^-1 F
// that state is x + D - (1 - tau) F: for tau = 1 the displacement is D itself, to the last bit. This form is
// ours.

#include <cstdint>
#include <span>

#include "collision/contact/pairs/particle_ranges.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"
#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

enum class CommonMotionKind : std::uint8_t {
    none,         ///< no particle had a finite position and displacement: A = I, t = 0
    translation,  ///< too few particles, or all on a line
    rigid,        ///< an affine map would turn inside out, flatten or stretch too much
    affine,
};

/// x -> A (x - c) + c + t.
struct CommonMotion {
    Vector3 centre = Vector3::Zero();       ///< c [m]
    Vector3 translation = Vector3::Zero();  ///< t [m]
    Matrix3 linear = Matrix3::Zero();       ///< A - I
    Matrix3 inverse = Matrix3::Identity();  ///< A^-1
    CommonMotionKind kind = CommonMotionKind::none;

    /// The displacement of a particle that has this motion and no other.
    [[nodiscard]] Vector3 of(const Vector3& x) const noexcept { return translation + linear * (x - centre); }
};

/// Fits a common motion: least squares over a group's finite particles, all of one weight; sums in double.
class CommonMotionFit {
  public:
    /// Bounds of the singular values of A: a gap keeps at least the fraction least_scale of its width, and
    /// displacements without the common motion grow at most by 1 / least_scale.
    static constexpr double least_scale = 0.3, most_scale = 3;

    void lay_out(Scratch& scratch, std::size_t particles, std::size_t ranges);

    /// In directions in which the particles have no extent (a flat sheet's normal) the map is that of the
    /// rigid motion that fits best. Spans are of all bodies' particles. `most`: the most general kind, affine
    /// or rigid.
    [[nodiscard]] CommonMotion fit(Parallel& parallel, std::span<const ParticleRange> group,
                                   std::span<const Vec4> positions, std::span<const Vec4> displacements,
                                   CommonMotionKind most = CommonMotionKind::affine);

  private:
    /// Moments of particles' positions u and displacements v, about a point near them.
    struct Moments {
        double count = 0;
        double u[3] = {}, v[3] = {};
        double uu[3][3] = {}, vu[3][3] = {};
    };
    static Moments add(const Moments& a, const Moments& b);

    ScratchArray<Moments> partials_;
};

/// Computes E of every particle of the group: its displacement without the common motion, in the frame of
/// that. Replaces x, y, z of `relative`; spans are of all bodies' particles.
void take_out(Parallel& parallel, const CommonMotion& common, std::span<const ParticleRange> group,
              std::span<const Vec4> positions, std::span<const Vec4> displacements, std::span<Vec4> relative);

/// D - (1 - tau) F: the displacement of a particle that moves the fraction tau of its relative motion. Finite
/// for tau = 0, whatever D is.
inline Vector3 give_back(const CommonMotion& common, const Vector3& x, const Vector3& displacement,
                         float tau) {
    if (tau >= 1) return displacement;
    const Vector3 shared = common.of(x);
    if (tau <= 0) return shared;
    return displacement - (1 - tau) * (displacement - shared);
}

}  // namespace weft
