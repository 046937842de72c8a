// The linear triangle as a membrane: values in, values out, for one triangle (Real = float, or double in
// tests) or for as many as a register holds (Real = Lanes). Compiled by Highway once for each kind of
// machine, as lanes-inl.h.
//
// The source's deformation gradient is square: F = [x0 x1 x2 n] [dphi/dX; N^T], n the deformed and N the rest
// unit normal. n is normal to both columns that span the triangle and has length 1, so F's third singular
// value is 1 wherever the triangle goes, its energy
//
//     psi = mu sum_i (s_i - 1)^2 + lambda/2 (s_1 + s_2 + s_3 - 3)^2
//
// does not depend on it, and dn/dq affects gradient and Hessian only by keeping it 1.
// What is left is F = [f1 f2], two columns in space, and its polar decomposition F = R S: R = [r1 r2] has
// orthonormal columns and S, symmetric 2x2 in the pattern's axes, has s_1 and s_2 as eigenvalues. In terms of
// the strain E = S - I
//
//     psi = (C11 E11^2 + C22 E22^2)/2 + C12 E11 E22 + 2 G E12^2    per rest area [N/m]
//
// which is the source's energy for C11 = C22 = 2 mu + lambda, C12 = lambda, G = mu (then 2 G E12^2 + .. is
// mu |E|^2 + lambda/2 (tr E)^2, which depends on eigenvalues only), and lets warp, weft and shear differ:
// orthotropic plane stress, Young's moduli Y1 and Y2, Poisson's ratios nu sqrt(Y1/Y2) and nu sqrt(Y2/Y1).

#if defined(WEFT_CLOTH_METHODS_FINITE_ELEMENTS_TRIANGLE_FEM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_METHODS_FINITE_ELEMENTS_TRIANGLE_FEM_INL_H
#undef WEFT_CLOTH_METHODS_FINITE_ELEMENTS_TRIANGLE_FEM_INL_H
#else
#define WEFT_CLOTH_METHODS_FINITE_ELEMENTS_TRIANGLE_FEM_INL_H
#endif

#include "engine/simd/real-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// The rest shape in the pattern's axes: dphi_k/dX of corners 1 and 2, that of corner 0 being minus their sum
/// [1/m].
template <class Real>
struct RestTriangle {
    Real x1, y1, x2, y2;
    Real area;  ///< [m^2]
};

/// C11, C22, C12 and G above [N/m].
template <class Real>
struct Elasticity {
    Real warp, weft, coupling, shear;
};

/// A symmetric 2x2 matrix in the pattern's axes.
template <class Real>
struct Planar {
    Real xx, yy, xy;
};

/// d/dX of a quantity given at the three corners: F for positions, the rate of F for velocities.
template <class Real>
struct Gradient {
    Point<Real> f1, f2;
};

template <class Real>
HWY_INLINE Gradient<Real> gradient(const RestTriangle<Real>& rest, const Point<Real>& at0,
                                   const Point<Real>& at1, const Point<Real>& at2) {
    const Point<Real> side1 = at1 - at0, side2 = at2 - at0;
    return {rest.x1 * side1 + rest.x2 * side2, rest.y1 * side1 + rest.y2 * side2};
}

/// F = R S and the unit normal n.
template <class Real>
struct Polar {
    Point<Real> r1, r2, n;
    Planar<Real> s;
    Real trace;       ///< of S, > 0
    Real area_ratio;  ///< det S, deformed over rest area
};

/// The unit normal of a triangle that has collapsed to a line along the longer column: any one of the normals
/// of the line.
template <class Real>
HWY_INLINE Point<Real> normal_of_line(const Gradient<Real>& f, Real squared1, Real squared2) {
    const Point<Real> line = where_less(squared1, squared2, f.f2, f.f1);
    const Real zero = splat<Real>(0);
    const Point<Real> across = where_less(absolute(line.x), absolute(line.z), {zero, zero - line.z, line.y},
                                          {zero - line.y, line.x, zero});
    return normalised(across);
}

// For a 2x2 matrix S = sqrt(F^T F) = (F^T F + J I) / tr S and R = (F + cof F) / tr S, with J = det S and
// tr S = sqrt(tr F^T F + 2 J). In space cof F = [f2 x n, n x f1]. A line still has an R, any of those about
// it; a triangle that has shrunk to a point is taken to lie as its pattern on the ground.
template <class Real>
HWY_INLINE Polar<Real> polar(const Gradient<Real>& f) {
    const Real least = splat<Real>(1e-10f);
    const Real xx = dot(f.f1, f.f1), yy = dot(f.f2, f.f2), xy = dot(f.f1, f.f2), total = xx + yy;
    const Point<Real> normal = cross(f.f1, f.f2);
    const Real j = square_root(dot(normal, normal));
    const Real zero = splat<Real>(0), one = splat<Real>(1);

    Polar<Real> p;
    p.n = where_less(splat<Real>(1e-5f) * total, j, (one / j) * normal, normal_of_line(f, xx, yy));
    p.n = where_less(least, total, p.n, {zero, one, zero});
    p.trace = square_root(largest(total + j + j, least));
    p.area_ratio = j;
    const Real inverse = one / p.trace;
    p.s = {inverse * (xx + j), inverse * (yy + j), inverse * xy};
    p.r1 = where_less(least, total, inverse * (f.f1 + cross(f.f2, p.n)), {one, zero, zero});
    p.r2 = where_less(least, total, inverse * (f.f2 + cross(p.n, f.f1)), {zero, zero, zero - one});
    return p;
}

/// dpsi/dE for a strain E; the energy is half their product.
template <class Real>
HWY_INLINE Planar<Real> stress(const Elasticity<Real>& c, const Planar<Real>& strain) {
    return {c.warp * strain.xx + c.coupling * strain.yy, c.coupling * strain.xx + c.weft * strain.yy,
            (c.shear + c.shear) * strain.xy};
}

template <class Real>
HWY_INLINE Planar<Real> strain(const Polar<Real>& p) {
    const Real one = splat<Real>(1);
    return {p.s.xx - one, p.s.yy - one, p.s.xy};
}

/// dS/dt where F moves at `rate`. R turns at w = (A21 - A12) / tr S, A = R^T dF/dt, and dS/dt = A - w J S, J
/// the quarter turn [0 -1; 1 0].
template <class Real>
HWY_INLINE Planar<Real> strain_rate(const Polar<Real>& p, const Gradient<Real>& rate) {
    const Real a12 = dot(p.r1, rate.f2);
    const Real w = (dot(p.r2, rate.f1) - a12) / p.trace;
    return {dot(p.r1, rate.f1) + w * p.s.xy, dot(p.r2, rate.f2) - w * p.s.xy, a12 + w * p.s.yy};
}

/// tau in dpsi/dF = R (sigma + tau J): the torque on R of a stress whose axes are not those of stretch. It is
/// 0 for isotropic cloth.
template <class Real>
HWY_INLINE Real twist(const Polar<Real>& p, const Planar<Real>& sigma) {
    return ((sigma.xx - sigma.yy) * p.s.xy - sigma.xy * (p.s.xx - p.s.yy)) / p.trace;
}

/// Forces on corners 1 and 2; that on corner 0 is minus their sum.
template <class Real>
struct CornerForces {
    Point<Real> on1, on2;
};

/// -area dpsi/dx_k = -area dpsi/dF dphi_k/dX. Viscous stress may be part of sigma.
template <class Real>
HWY_INLINE CornerForces<Real> forces(const RestTriangle<Real>& rest, const Polar<Real>& p,
                                     const Planar<Real>& sigma) {
    const Real tau = twist(p, sigma), minus_area = splat<Real>(0) - rest.area;
    const Point<Real> p1 = minus_area * (sigma.xx * p.r1 + (sigma.xy + tau) * p.r2);
    const Point<Real> p2 = minus_area * ((sigma.xy - tau) * p.r1 + sigma.yy * p.r2);
    return {rest.x1 * p1 + rest.y1 * p2, rest.x2 * p1 + rest.y2 * p2};
}

/// The nearest symmetric matrix without a negative eigenvalue.
template <class Real>
HWY_INLINE Planar<Real> positive_part(const Planar<Real>& m) {
    const Real zero = splat<Real>(0), half = splat<Real>(0.5f);
    const Real mean = half * (m.xx + m.yy), difference = half * (m.xx - m.yy);
    const Real radius = square_root(difference * difference + m.xy * m.xy);
    const Real low = mean - radius, high = largest(mean + radius, zero);
    // Where one eigenvalue is negative: the other one, times its projector (M - low I) / (high - low).
    const Real part = high / largest(radius + radius, splat<Real>(1e-30f));
    const Real scale = where_less(low, zero, part, splat<Real>(1));
    const Real shift = where_less(low, zero, low, zero);
    return {scale * (m.xx - shift), scale * (m.yy - shift), scale * m.xy};
}

/// The second derivative of psi splits in two. Out of the plane, for dF with n^T dF = b^T:
///
///     b^T (2 dpsi/d(F^T F)) b,   2 dpsi/d(F^T F) = S^-1 (sigma + tau J)                      tension, mostly
///
/// In the plane, for the strain e and the turn w of dF (see strain_rate):
///
///     e : C : e + 2 w g : e + w^2 h,   h = sigma : S,   g = sym(J sigma) - tau I
///
/// Both are made positive semi-definite: the first by its positive part; the second, which C > 0 makes
/// indefinite exactly where h < g : C^-1 : g, by h -> max(h, 0) and g -> g sqrt(h / g : C^-1 : g) there. So
/// the Hessian is exact wherever the exact one is semi-definite, and stays bounded as the triangle collapses.
template <class Real>
struct SecondDerivative {
    Planar<Real> out_of_plane;
    Elasticity<Real> c;
    Planar<Real> g;
    Real h;
};

/// `elastic` times the second derivative of psi, plus `viscous` times C in the plane.
template <class Real>
HWY_INLINE SecondDerivative<Real> second_derivative(const Elasticity<Real>& c, const Polar<Real>& p,
                                                    const Planar<Real>& sigma, Real elastic, Real viscous) {
    const Real zero = splat<Real>(0), half = splat<Real>(0.5f), one = splat<Real>(1);
    const Real tau = twist(p, sigma);
    const Real ratio = elastic / largest(p.area_ratio, splat<Real>(1e-4f) * p.trace * p.trace);
    const Planar<Real> tension{ratio * (p.s.yy * sigma.xx - p.s.xy * (sigma.xy + tau)),
                               ratio * (p.s.xx * sigma.yy - p.s.xy * (sigma.xy - tau)),
                               ratio * (p.s.yy * (sigma.xy - tau) - p.s.xy * sigma.yy)};

    const Real h = largest(sigma.xx * p.s.xx + sigma.yy * p.s.yy + (sigma.xy + sigma.xy) * p.s.xy, zero);
    const Planar<Real> g{zero - sigma.xy - tau, sigma.xy - tau, half * (sigma.xx - sigma.yy)};
    const Real bound =
        (c.weft * g.xx * g.xx - (c.coupling + c.coupling) * g.xx * g.yy + c.warp * g.yy * g.yy) /
            (c.warp * c.weft - c.coupling * c.coupling) +
        g.xy * g.xy / c.shear;
    const Real kept = elastic * square_root(smallest(h / largest(bound, splat<Real>(1e-30f)), one));
    const Real stiff = elastic + viscous;
    return {.out_of_plane = positive_part(tension),
            .c = {stiff * c.warp, stiff * c.weft, stiff * c.coupling, stiff * c.shear},
            .g = {kept * g.xx, kept * g.yy, kept * g.xy},
            .h = elastic * h};
}

/// Strain and turn when one corner moves by 1 along r1 or along r2.
template <class Real>
struct Response {
    Real xx, yy, xy, w;
};

template <class Real>
HWY_INLINE Real product(const SecondDerivative<Real>& d, const Response<Real>& a, const Response<Real>& b) {
    const Real four = splat<Real>(4);
    const Real in_a = d.g.xx * a.xx + d.g.yy * a.yy + (d.g.xy + d.g.xy) * a.xy;
    const Real in_b = d.g.xx * b.xx + d.g.yy * b.yy + (d.g.xy + d.g.xy) * b.xy;
    return d.c.warp * a.xx * b.xx + d.c.weft * a.yy * b.yy + d.c.coupling * (a.xx * b.yy + a.yy * b.xx) +
           four * d.c.shear * a.xy * b.xy + in_a * b.w + in_b * a.w + d.h * a.w * b.w;
}

/// Second derivatives of area psi by two corners: in the plane a 2x2 block by r1 and r2, and one value along
/// n.
template <class Real>
struct PlaneBlock {
    Real xx, xy, yx, yy, nn;

    HWY_INLINE PlaneBlock transposed() const { return {xx, yx, xy, yy, nn}; }
    HWY_INLINE friend PlaneBlock operator+(const PlaneBlock& a, const PlaneBlock& b) {
        return {a.xx + b.xx, a.xy + b.xy, a.yx + b.yx, a.yy + b.yy, a.nn + b.nn};
    }
};

/// The strain's response to corner k, whose dphi_k/dX is (x, y).
template <class Real>
struct CornerResponse {
    Real x, y;
    Response<Real> along1, along2;
};

template <class Real>
HWY_INLINE CornerResponse<Real> corner_response(const Polar<Real>& p, Real x, Real y) {
    const Real w1 = splat<Real>(0) - y / p.trace, w2 = x / p.trace;
    return {.x = x,
            .y = y,
            .along1 = {x + w1 * p.s.xy, splat<Real>(0) - w1 * p.s.xy, y + w1 * p.s.yy, w1},
            .along2 = {w2 * p.s.xy, y - w2 * p.s.xy, w2 * p.s.yy, w2}};
}

template <class Real>
HWY_INLINE PlaneBlock<Real> plane_block(const SecondDerivative<Real>& d, Real area,
                                        const CornerResponse<Real>& a, const CornerResponse<Real>& b) {
    const Planar<Real>& t = d.out_of_plane;
    return {area * product(d, a.along1, b.along1), area * product(d, a.along1, b.along2),
            area * product(d, a.along2, b.along1), area * product(d, a.along2, b.along2),
            area * (a.x * (t.xx * b.x + t.xy * b.y) + a.y * (t.xy * b.x + t.yy * b.y))};
}

/// Rows of a 3x3 block.
template <class Real>
struct Block {
    Point<Real> x, y, z;
};

template <class Real>
HWY_INLINE Block<Real> block_in_space(const Polar<Real>& p, const PlaneBlock<Real>& k) {
    const Point<Real> to1 = k.xx * p.r1 + k.xy * p.r2, to2 = k.yx * p.r1 + k.yy * p.r2, to_n = k.nn * p.n;
    return {p.r1.x * to1 + p.r2.x * to2 + p.n.x * to_n, p.r1.y * to1 + p.r2.y * to2 + p.n.y * to_n,
            p.r1.z * to1 + p.r2.z * to2 + p.n.z * to_n};
}

/// The Hessian's blocks off the diagonal, with the sign turned: -d2(area psi)/dx_a dx_b for corners (0, 1),
/// (1, 2) and (2, 0). Those of the opposite order are their transposes, and each row of blocks sums to 0.
template <class Real>
struct Stiffness {
    Block<Real> from0to1, from1to2, from2to0;
    Real tension01, tension12, tension20;  ///< what the blocks have along the triangle's normal
};

template <class Real>
HWY_INLINE Stiffness<Real> stiffness(const RestTriangle<Real>& rest, const Polar<Real>& p,
                                     const SecondDerivative<Real>& d) {
    const Real minus_area = splat<Real>(0) - rest.area;
    const CornerResponse<Real> one = corner_response(p, rest.x1, rest.y1),
                               two = corner_response(p, rest.x2, rest.y2);
    const PlaneBlock<Real> k11 = plane_block(d, rest.area, one, one),
                           k22 = plane_block(d, rest.area, two, two);
    const PlaneBlock<Real> k12 = plane_block(d, rest.area, one, two);
    const PlaneBlock<Real> k01 = k11 + k12.transposed(), minus12 = plane_block(d, minus_area, one, two),
                           k20 = k22 + k12.transposed();
    return {block_in_space(p, k01),
            block_in_space(p, minus12),
            block_in_space(p, k20),
            k01.nn,
            minus12.nn,
            k20.nn};
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
