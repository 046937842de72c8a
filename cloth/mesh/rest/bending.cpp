#include "cloth/mesh/rest/bending.h"

#include <algorithm>
#include <cmath>

#include "engine/angle.h"

namespace weft {

namespace {

/// Calls body for the terms of k phi_e phi_f.
void append_terms(const Hinge& e, const Hinge& f, float k,
                  const std::function<void(std::uint32_t, std::uint32_t, float)>& body) {
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < 4; ++b)
            if (e.particles[a] != f.particles[b]) body(e.particles[a], f.particles[b], k * e.q[a] * f.q[b]);
}

}  // namespace

void for_each_quadratic_term(const Bending& bending,
                             const std::function<void(std::uint32_t, std::uint32_t, float)>& body) {
    for (const Hinge& hinge : bending.hinges) append_terms(hinge, hinge, hinge.weight, body);
    for (const HingePair& pair : bending.pairs) {
        append_terms(bending.hinges[pair.first], bending.hinges[pair.second], pair.weight, body);
        append_terms(bending.hinges[pair.second], bending.hinges[pair.first], pair.weight, body);
    }
}

// d theta/dx of an apex is its triangle's unit normal over its height above the edge. The edge's ends get the
// opposite, in shares by where the apex's foot lies between them, so that rigid motions keep the angle.
Dihedral dihedral(const std::array<Vector3, 4>& x, float least_height) {
    const Vector3 edge = x[1] - x[0];
    const float squared = std::max({edge.squaredNorm(), least_height * least_height, 1e-30f});
    const float length = std::sqrt(squared);
    const Vector3 side2 = x[2] - x[0], side3 = x[3] - x[0];
    const Vector3 n2 = edge.cross(side2), n3 = side3.cross(edge);
    const auto slope = [&](const Vector3& n) -> Vector3 {
        const float least = length * least_height;
        return -length / std::max({n.squaredNorm(), least * least, 1e-30f}) * n;
    };
    const Vector3 apex2 = slope(n2), apex3 = slope(n3);
    const float foot2 = side2.dot(edge) / squared, foot3 = side3.dot(edge) / squared;
    return {
        .angle = static_cast<float>(angle_of(double{n2.cross(n3).dot(edge) / length}, double{n2.dot(n3)})),
        .gradient = {-(1 - foot2) * apex2 - (1 - foot3) * apex3, -foot2 * apex2 - foot3 * apex3, apex2,
                     apex3}};
}

}  // namespace weft
