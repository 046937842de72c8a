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

/// An edge of two triangles.
struct SharedEdge {
    std::array<std::uint32_t, 2> triangles;
    float length;  ///< of the edge [m]
};

std::vector<SharedEdge> neighbours_of(const PlainSurface& surface) {
    std::vector<SharedEdge> neighbours;
    const std::vector<Side> sides = sides_by_edge(surface.triangles);
    for (std::size_t s = 0; s < sides.size(); s += sides_of_edge(sides, s).size()) {
        const auto edge = sides_of_edge(sides, s);
        if (edge.size() != 2) continue;
        const float length = (surface.points[edge[0].high] - surface.points[edge[0].low]).norm();
        neighbours.push_back({{edge[0].triangle, edge[1].triangle}, length});
    }
    return neighbours;
}

/// Way over a rim, from a triangle on one of its sides [m].
float way_over_rim(const PlainSurface& surface, float thickness, std::uint32_t t) {
    return 2 * (thickness + std::sqrt(area_of(surface, surface.triangles[t])));
}

/// Leaves out, too, what continues a layer that is left out: next to a rim, the rim is nearer than the back.
void leave_out_to_rims(const PlainSurface& surface, const std::vector<SharedEdge>& neighbours,
                       float thickness, std::vector<bool>& kept) {
    std::vector<std::uint32_t> sources(kept.size(), none);  // for each triangle left out, where that began
    for (std::uint32_t t = 0; t < kept.size(); ++t)
        if (!kept[t]) sources[t] = t;
    for (bool is_done = false; !is_done;) {
        is_done = true;
        for (const auto& [pair, length] : neighbours) {
            const auto [a, b] = pair;
            if (kept[a] == kept[b]) continue;
            const std::uint32_t inner = kept[a] ? b : a, next = kept[a] ? a : b;
            const float way = (middle_of(surface, next) - middle_of(surface, sources[inner])).norm();
            const float alike = normal_of(surface, next).dot(normal_of(surface, inner));
            if (!(way < way_over_rim(surface, thickness, next) && alike > 0.7f)) continue;
            kept[next] = false;
            sources[next] = sources[inner];
            is_done = false;
        }
    }
}

/// Keeps the layers that are folded, not doubled: the sides of a tight fold lie as near, and the cloth would
/// be torn where one of them is left out. A doubled mesh's layer ends at rims, over which its other layer
/// begins; that of a fold does so at one of its ends, and goes on at the other.
void keep_folds(const PlainSurface& surface, const std::vector<SharedEdge>& neighbours, float thickness,
                const std::vector<std::uint32_t>& backs, std::vector<bool>& kept) {
    std::vector<std::vector<std::uint32_t>> beside(kept.size());
    for (const auto& [pair, length] : neighbours)
        for (const std::size_t k : {0, 1}) beside[pair[k]].push_back(pair[1 - k]);
    std::vector<bool> left_out = kept;
    left_out.flip();
    const std::vector<std::uint32_t> layers = parts_of(surface, left_out);
    const auto is_other_layer = [&](std::uint32_t t, std::uint32_t layer) {
        return backs[t] != none && !kept[backs[t]] && layers[backs[t]] == layer;
    };
    std::vector<std::uint32_t> seen_from(kept.size(), none), near;
    const auto finds_other_layer = [&](std::uint32_t from, std::uint32_t layer, std::uint32_t search) {
        const float reach = way_over_rim(surface, thickness, from);
        near.assign(1, from);
        seen_from[from] = search;
        for (std::size_t k = 0; k < near.size(); ++k) {
            if (is_other_layer(near[k], layer)) return true;
            for (const std::uint32_t next : beside[near[k]]) {
                if (!kept[next] || seen_from[next] == search) continue;
                if ((middle_of(surface, next) - middle_of(surface, from)).norm() > reach) continue;
                seen_from[next] = search;
                near.push_back(next);
            }
        }
        return false;
    };
    std::vector<float> surplus(
        kept.size());  // by layer: length of ends that go on, beyond a share of all ends
    constexpr float share = 0.25f;
    for (std::uint32_t e = 0; e < neighbours.size(); ++e) {
        const auto [a, b] = neighbours[e].triangles;
        if (kept[a] == kept[b]) continue;
        const std::uint32_t layer = layers[kept[a] ? b : a];
        const bool goes_on = !finds_other_layer(kept[a] ? a : b, layer, e);
        surplus[layer] += ((goes_on ? 1.0f : 0.0f) - share) * neighbours[e].length;
    }
    for (std::size_t t = 0; t < kept.size(); ++t)
        if (surplus[layers[t]] > 0) kept[t] = true;
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
    const std::vector<SharedEdge> neighbours = neighbours_of(surface);
    leave_out_to_rims(surface, neighbours, thickness, kept);
    keep_folds(surface, neighbours, thickness, backs, kept);
    return kept;
}

}  // namespace weft
