#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "cloth/mesh/topology/repair.h"
#include "cloth/proxy/plain_surface.h"
#include "weft/types.h"

namespace weft {

namespace {

constexpr std::uint32_t none = ~0u;

Vector3 middle_of(const PlainSurface& surface, std::uint32_t t) {
    const auto& [a, b, c] = surface.triangles[t];
    return (surface.points[a] + surface.points[b] + surface.points[c]) / 3;
}

Vector3 normal_of(const PlainSurface& surface, std::uint32_t t) {
    const auto& [a, b, c] = surface.triangles[t];
    const Vector3& origin = surface.points[a];
    return (surface.points[b] - origin).cross(surface.points[c] - origin).stableNormalized();
}

/// For each triangle the one that lies behind it, faces the other way, and is near; or none.
std::vector<std::uint32_t> backs_of(const PlainSurface& surface, float thickness) {
    const NearestTriangle nearest = nearest_on(surface);
    std::vector<std::uint32_t> backs;
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
        const Vector3 middle = middle_of(surface, t), normal = normal_of(surface, t);
        const auto found = nearest.to(middle, -normal, thickness);
        backs.push_back(none);
        if (!found || !(normal_of(surface, found->triangle).dot(normal) < -0.5f)) continue;
        const auto& [i, j, k] = surface.triangles[found->triangle];
        const Vector3 there = (1 - found->second - found->third) * surface.points[i] +
                              found->second * surface.points[j] + found->third * surface.points[k];
        if ((there - middle).dot(normal) <= 1e-6f) backs.back() = found->triangle;
    }
    return backs;
}

/// Leaves out, too, what continues a layer that is left out: next to a rim, the rim is nearer than the back.
void leave_out_to_rims(const PlainSurface& surface, float thickness, std::vector<bool>& kept) {
    std::vector<std::array<std::uint32_t, 2>> neighbours;
    const std::vector<Side> sides = sides_by_edge(surface.triangles);
    for (std::size_t s = 0; s < sides.size(); s += sides_of_edge(sides, s).size()) {
        const auto edge = sides_of_edge(sides, s);
        if (edge.size() == 2) neighbours.push_back({edge[0].triangle, edge[1].triangle});
    }
    std::vector<std::uint32_t> sources(kept.size(), none);  // for each triangle left out, where that began
    for (std::uint32_t t = 0; t < kept.size(); ++t)
        if (!kept[t]) sources[t] = t;
    for (bool is_done = false; !is_done;) {
        is_done = true;
        for (const auto& [a, b] : neighbours) {
            if (kept[a] == kept[b]) continue;
            const std::uint32_t inner = kept[a] ? b : a, next = kept[a] ? a : b;
            const float way = (middle_of(surface, next) - middle_of(surface, sources[inner])).norm();
            const float size = std::sqrt(area_of(surface, surface.triangles[next]));
            const float alike = normal_of(surface, next).dot(normal_of(surface, inner));
            if (!(way < 2 * (thickness + size) && alike > 0.7f)) continue;
            kept[next] = false;
            sources[next] = sources[inner];
            is_done = false;
        }
    }
}

/// Keeps the parts of which too little would be left out for a doubled mesh: the sides of a tight fold lie as
/// near, and the cloth would be torn where one of them is left out.
void keep_folded_parts(const PlainSurface& surface, std::vector<bool>& kept) {
    constexpr float least_share = 0.25f;  // of a part's area
    const std::vector<std::uint32_t> parts = parts_of(surface, std::vector<bool>(kept.size(), true));
    std::vector<float> surplus(surface.triangles.size());  // by part: what is left out beyond that share
    for (std::size_t t = 0; t < kept.size(); ++t)
        surplus[parts[t]] += ((kept[t] ? 0 : 1) - least_share) * area_of(surface, surface.triangles[t]);
    for (std::size_t t = 0; t < kept.size(); ++t)
        if (surplus[parts[t]] < 0) kept[t] = true;
}

}  // namespace

std::vector<bool> outer_layers(const PlainSurface& surface, float thickness) {
    std::vector<bool> kept(surface.triangles.size(), true);
    if (!(thickness > 0)) return kept;
    const std::vector<std::uint32_t> backs = backs_of(surface, thickness);
    std::vector<bool> is_doubled;
    for (const std::uint32_t back : backs) is_doubled.push_back(back != none);
    const std::vector<std::uint32_t> layers = parts_of(surface, is_doubled);
    std::vector<float> areas(surface.triangles.size());
    std::map<std::uint32_t, std::map<std::uint32_t, float>> behind;  // areas, by a layer and that at its back
    for (std::size_t t = 0; t < backs.size(); ++t) {
        if (!is_doubled[t]) continue;
        const float area = area_of(surface, surface.triangles[t]);
        areas[layers[t]] += area;
        behind[layers[t]][layers[backs[t]]] += area;
    }
    std::map<std::uint32_t, std::uint32_t> back_layers;
    for (const auto& [layer, others] : behind)
        back_layers[layer] =
            std::ranges::max_element(others, {}, [](const auto& of) { return of.second; })->first;
    std::vector<bool> is_inner(areas.size());
    for (const auto& [layer, other] : back_layers)  // layers are each other's backs, not patches of one
        is_inner[layer] =
            back_layers[other] == layer && std::pair(areas[layer], other) < std::pair(areas[other], layer);
    for (std::size_t t = 0; t < kept.size(); ++t) kept[t] = !(is_doubled[t] && is_inner[layers[t]]);
    leave_out_to_rims(surface, thickness, kept);
    keep_folded_parts(surface, kept);
    return kept;
}

}  // namespace weft
