#include "demo/window/pick.h"

#include <algorithm>
#include <cmath>

#include "engine/vector.h"

namespace weft::demo {
namespace {

struct Corners {
    Vector3 a, b, c;
};

/// Distance along the ray to the triangle, by Moeller and Trumbore 1997.
std::optional<float> distance_to(const Corners& t, const Vector3& origin, const Vector3& direction) {
    const Vector3 ab = t.b - t.a, ac = t.c - t.a;
    const Vector3 p = direction.cross(ac);
    const float determinant = ab.dot(p);
    if (determinant == 0) return std::nullopt;
    const Vector3 from_a = origin - t.a;
    const float u = from_a.dot(p) / determinant;
    const Vector3 q = from_a.cross(ab);
    const float v = direction.dot(q) / determinant;
    const float distance = ac.dot(q) / determinant;
    if (!(u >= 0 && v >= 0 && u + v <= 1 && distance > 0)) return std::nullopt;
    return distance;
}

}  // namespace

std::optional<Hit> first_hit(const ClothView& cloth, const render::Ray& ray) {
    const Vector3 origin = to_vector(ray.origin), direction = to_vector(ray.direction);
    const auto position = [&](std::uint32_t particle) { return xyz(cloth.positions[particle]); };
    std::optional<Hit> first;
    for (const Triangle& t : cloth.triangles) {
        const auto distance =
            distance_to({position(t[0]), position(t[1]), position(t[2])}, origin, direction);
        if (!distance || (first && *distance >= first->distance)) continue;
        const Vector3 point = origin + *distance * direction;
        const std::uint32_t nearest = *std::ranges::min_element(
            t, {}, [&](std::uint32_t particle) { return (position(particle) - point).squaredNorm(); });
        first = Hit{*distance, nearest};
    }
    return first;
}

}  // namespace weft::demo
