#pragma once
// The motion that a group's particles have in common. It brings nothing nearer to anything, so only what is
// left without it need ever be cut.
//
// Why that is allowed: an affine map with an inverse maps a state without crossings to one without, since it
// is one-to-one and takes straight edges and flat triangles to such. So let y = x + tau E be free of
// crossings; then A (y - c) + c + t is so too, whatever the tau of each particle. With
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
    rigid,        ///< affine would have been too near to turning inside out, or to flattening
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

/// Least squares over the finite particles of a group, all of one weight; sums in double.
class CommonMotionFit {
  public:
    /// No singular value of A is below the first or above the second: a gap keeps at least that share of its
    /// width, and displacements without the common motion are at most the inverse of it times larger.
    static constexpr double least_scale = 0.3, most_scale = 3;

    void lay_out(Scratch& scratch, std::size_t particles, std::size_t ranges);

    /// In directions in which the particles have no extent (a flat sheet's normal) the map is that of the
    /// rigid motion that fits best. Spans are of all bodies' particles. `most`: affine, or no more than
    /// rigid.
    [[nodiscard]] CommonMotion fit(Parallel& parallel, std::span<const ParticleRange> group,
                                   std::span<const Vec4> positions, std::span<const Vec4> displacements,
                                   CommonMotionKind most = CommonMotionKind::affine);

  private:
    /// Of particles, about a point near them: u their positions, v their displacements.
    struct Moments {
        double count = 0;
        double u[3] = {}, v[3] = {};
        double uu[3][3] = {}, vu[3][3] = {};
    };
    static Moments add(const Moments& a, const Moments& b);

    ScratchArray<Moments> partials_;
};

/// E of every particle of the group: what is left of its displacement, in the frame of the common motion.
/// Replaces x, y, z of relative; spans are of all bodies' particles.
void take_out(Parallel& parallel, const CommonMotion& common, std::span<const ParticleRange> group,
              std::span<const Vec4> positions, std::span<const Vec4> displacements, std::span<Vec4> relative);

/// D - (1 - tau) F: the displacement of a particle that goes the part tau of its relative motion. Finite for
/// tau = 0, whatever D is.
inline Vector3 give_back(const CommonMotion& common, const Vector3& x, const Vector3& displacement,
                         float tau) {
    if (tau >= 1) return displacement;
    const Vector3 shared = common.of(x);
    if (tau <= 0) return shared;
    return displacement - (1 - tau) * (displacement - shared);
}

}  // namespace weft
