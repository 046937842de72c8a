#pragma once
// The linear system of one implicit step, W dv = b, stored by rows so that solvers only gather.
//
// Row i:  D_i dv_i - sum_j A_ij dv_j = b_i,  with  D_i = r_i I + sum_j A_ij.
// A_ij = a I + d d^T is symmetric positive semi-definite, r_i > 0 the row sum, so W is symmetric positive
// definite.

#include <cstdint>

#include "engine/aligned_buffer.h"
#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

/// A symmetric 3x3 matrix.
struct Symmetric3 {
    float xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

    [[nodiscard]] Vector3 operator*(const Vector3& v) const {
        return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
                xz * v.x() + yz * v.y() + zz * v.z()};
    }
    /// Adds a I + d d^T.
    void add(float a, const Vector3& d) {
        xx += a + d.x() * d.x();
        yy += a + d.y() * d.y();
        zz += a + d.z() * d.z();
        xy += d.x() * d.y();
        xz += d.x() * d.z();
        yz += d.y() * d.z();
    }
};

/// The inverse of a matrix whose eigenvalues are at least `least` > 0. A direction that is so much softer
/// than the stiffest that single precision has lost it counts as heavier instead of as lighter than it is:
/// the inverse stays positive definite, and no larger than about 1 / least, at any stiffness.
[[nodiscard]] Symmetric3 inverse(const Symmetric3& m, float least);

struct ImplicitSystem {
    AlignedBuffer<Vec4> coefficients;  ///< per half-edge: x y z of d [sqrt(kg)], w a [kg]
    AlignedBuffer<Vec4> right_side;    ///< b_i [kg m/s], w row sum r_i [kg]; 0 for pinned particles
    AlignedBuffer<Symmetric3>
        inverse_diagonal;                 ///< D_i^-1 [1/kg]; 0 for pinned particles, which so never move
    AlignedBuffer<Vec4> velocity_change;  ///< dv_i [m/s], the solution
    AlignedBuffer<Vec4> scratch;          ///< the other buffer of an iteration

    ImplicitSystem() = default;
    ImplicitSystem(std::uint32_t particles, std::size_t half_edges)
        : coefficients(half_edges),
          right_side(particles),
          inverse_diagonal(particles),
          velocity_change(particles),
          scratch(particles) {}

    [[nodiscard]] std::size_t bytes() const noexcept {
        return coefficients.bytes() + right_side.bytes() + inverse_diagonal.bytes() +
               velocity_change.bytes() + scratch.bytes();
    }
};

}  // namespace weft
