#include "demo/study/crossings/triangle_soup.h"

#include <algorithm>
#include <cmath>

namespace weft::study {

void TriangleSoup::add(const ClothView& cloth) {
    std::vector<Vec3> places;
    places.reserve(cloth.positions.size());
    for (const Vec4& p : cloth.positions) places.push_back({p.x, p.y, p.z});
    add_body(places, {cloth.triangles.begin(), cloth.triangles.end()});
}

void TriangleSoup::add_body(const std::vector<Vec3>& more, const std::vector<Triangle>& their_triangles) {
    const auto first = static_cast<std::uint32_t>(points.size());
    const std::uint32_t body = bodies.empty() ? 0 : bodies.back() + 1;
    points.insert(points.end(), more.begin(), more.end());
    for (const auto& [a, b, c] : their_triangles) {
        triangles.push_back({first + a, first + b, first + c});
        bodies.push_back(body);
    }
}

bool TriangleSoup::share_a_vertex(std::uint32_t first, std::uint32_t second) const {
    const auto& [a, b, c] = triangles[first];
    const auto is_shared = [&](std::uint32_t p) { return p == a || p == b || p == c; };
    return std::ranges::any_of(triangles[second], is_shared);
}

bool TriangleSoup::finite() const {
    return std::ranges::all_of(
        points, [](const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); });
}

}  // namespace weft::study
