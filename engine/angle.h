#pragma once
// Angles whose bytes do not depend on the system's mathematical library, as std::atan2's do.

#include <cmath>

namespace weft {

namespace detail {

/// atan(y / x) of two numbers of which none is negative, by Moshier's rational approximation (Cephes, 1989).
inline double angle_in_quadrant(double y, double x) {
    double t = y <= x ? (x > 0 ? y / x : 0) : x / y, base = 0;
    if (t > 0.41421356237309503) {  // tan(pi / 8)
        t = (t - 1) / (t + 1);
        base = 0.78539816339744828;  // pi / 4
    }
    const double z = t * t;
    const double p =
        (((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z - 7.500855792314704667340e1) * z -
         1.228866684490136173410e2) *
            z -
        6.485021904942025371773e1;
    const double q =
        ((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z + 4.328810604912902668951e2) *
             z +
         4.853903996359136964868e2) *
            z +
        1.945506571482613964425e2;
    const double angle = base + (t + t * (z * p / q));
    return y <= x ? angle : 1.5707963267948966 - angle;
}

}  // namespace detail

/// std::atan2, within 5e-16 of its value: sums and products alone, which all machines round alike.
inline double angle_of(double y, double x) {
    const double angle = detail::angle_in_quadrant(std::abs(y), std::abs(x));
    return std::copysign(std::signbit(x) ? 3.1415926535897931 - angle : angle, y);
}

}  // namespace weft
