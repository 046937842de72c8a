// Arithmetic that reads the same for one number (float, double) and for one in each lane of a register
// (Lanes), so that a kernel is written once and can be checked in double precision. Included as lanes-inl.h.

#if defined(WEFT_ENGINE_SIMD_REAL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_ENGINE_SIMD_REAL_INL_H
#undef WEFT_ENGINE_SIMD_REAL_INL_H
#else
#define WEFT_ENGINE_SIMD_REAL_INL_H
#endif

#include <algorithm>
#include <cmath>
#include <concepts>

#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

template <class Real>
HWY_INLINE Real splat(float value) {
    if constexpr (std::floating_point<Real>) {
        return static_cast<Real>(value);
    } else {
        return hn::Set(Tag(), value);
    }
}

template <class Real>
HWY_INLINE Real square_root(Real a) {
    if constexpr (std::floating_point<Real>) {
        return std::sqrt(a);
    } else {
        return hn::Sqrt(a);
    }
}

template <class Real>
HWY_INLINE Real absolute(Real a) {
    if constexpr (std::floating_point<Real>) {
        return std::abs(a);
    } else {
        return hn::Abs(a);
    }
}

template <class Real>
HWY_INLINE Real largest(Real a, Real b) {
    if constexpr (std::floating_point<Real>) {
        return std::max(a, b);
    } else {
        return hn::Max(a, b);
    }
}

template <class Real>
HWY_INLINE Real smallest(Real a, Real b) {
    if constexpr (std::floating_point<Real>) {
        return std::min(a, b);
    } else {
        return hn::Min(a, b);
    }
}

/// a < b ? then : otherwise, in each lane.
template <class Real>
HWY_INLINE Real where_less(Real a, Real b, Real then, Real otherwise) {
    if constexpr (std::floating_point<Real>) {
        return a < b ? then : otherwise;
    } else {
        return hn::IfThenElse(hn::Lt(a, b), then, otherwise);
    }
}

/// A vector of space.
template <class Real>
struct Point {
    Real x, y, z;
};

template <class Real>
HWY_INLINE Point<Real> operator+(const Point<Real>& a, const Point<Real>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
HWY_INLINE Point<Real> operator-(const Point<Real>& a, const Point<Real>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
HWY_INLINE Point<Real> operator*(Real s, const Point<Real>& v) {
    return {s * v.x, s * v.y, s * v.z};
}
template <class Real>
HWY_INLINE Real dot(const Point<Real>& a, const Point<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
HWY_INLINE Point<Real> cross(const Point<Real>& a, const Point<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real>
HWY_INLINE Point<Real> normalised(const Point<Real>& v) {
    return (splat<Real>(1) / square_root(dot(v, v))) * v;
}
template <class Real>
HWY_INLINE Point<Real> where_less(Real a, Real b, const Point<Real>& then, const Point<Real>& otherwise) {
    return {where_less(a, b, then.x, otherwise.x), where_less(a, b, then.y, otherwise.y),
            where_less(a, b, then.z, otherwise.z)};
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
