#pragma once
// Whether an edge goes through a triangle, by signs of volumes.

namespace weft::test {

/// Six times the volume of a tetrahedron, signed.
template <class Point>
auto volume(const Point& a, const Point& b, const Point& c, const Point& d) {
    return (b - a).cross(c - a).dot(d - a);
}

/// The ends of pq are on two sides of the triangle's plane, and the line is inside or on its border.
template <class Point>
bool cuts(const Point& p, const Point& q, const Point& a, const Point& b, const Point& c) {
    if (volume(a, b, c, p) * volume(a, b, c, q) >= 0) return false;
    const auto ab = volume(p, q, a, b), bc = volume(p, q, b, c), ca = volume(p, q, c, a);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

}  // namespace weft::test
