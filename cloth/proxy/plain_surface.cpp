#include "cloth/proxy/plain_surface.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "cloth/mesh/topology/repair.h"
#include "engine/joined_sets.h"

namespace weft {

namespace {

/// Points halfway along edges, one an edge.
class Middles {
  public:
    explicit Middles(std::vector<Vector3>& points) : points_(points) {}
    std::uint32_t of(std::uint32_t a, std::uint32_t b) {
        const auto [at, is_new] =
            of_edge_.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(points_.size()));
        if (is_new) points_.push_back(0.5f * (points_[a] + points_[b]));
        return at->second;
    }

  private:
    std::vector<Vector3>& points_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> of_edge_;
};

}  // namespace

Result<PlainSurface> plain_surface(const Mesh& mesh) {
    auto topology = build_topology(mesh);
    if (!topology) return topology.error();
    PlainSurface surface;
    for (const std::uint32_t vertex : topology->first_vertices)
        surface.points.push_back(to_vector(mesh.positions[vertex]));
    surface.triangles = std::move(topology->triangles);
    return kept_of(surface, std::vector<bool>(surface.triangles.size(), true));
}

NearestTriangle nearest_on(const PlainSurface& surface) {
    std::vector<Vec4> positions;
    for (const Vector3& p : surface.points) positions.push_back(to_vec4(p, 0));
    return NearestTriangle({.positions = positions, .triangles = surface.triangles});
}

PlainSurface kept_of(const PlainSurface& surface, const std::vector<bool>& kept) {
    constexpr std::uint32_t unused = ~0u;
    std::vector<std::uint32_t> numbers(surface.points.size(), unused);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        if (!kept[t]) continue;
        for (const std::uint32_t corner : surface.triangles[t]) numbers[corner] = 0;
    }
    PlainSurface left;
    for (std::size_t p = 0; p < surface.points.size(); ++p) {
        if (numbers[p] == unused) continue;
        numbers[p] = static_cast<std::uint32_t>(left.points.size());
        left.points.push_back(surface.points[p]);
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto& [a, b, c] = surface.triangles[t];
        if (kept[t]) left.triangles.push_back({numbers[a], numbers[b], numbers[c]});
    }
    return left;
}

float area_of(const PlainSurface& surface, const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const Vector3& origin = surface.points[a];
    return 0.5f * (surface.points[b] - origin).cross(surface.points[c] - origin).norm();
}

std::vector<std::uint32_t> parts_of(const PlainSurface& surface, const std::vector<bool>& joined) {
    JoinedSets parts(surface.triangles.size());
    const std::vector<Side> sides = sides_by_edge(surface.triangles);
    for (std::size_t s = 0; s < sides.size(); s += sides_of_edge(sides, s).size()) {
        const auto edge = sides_of_edge(sides, s);
        if (edge.size() == 2 && joined[edge[0].triangle] && joined[edge[1].triangle])
            parts.join(edge[0].triangle, edge[1].triangle);
    }
    return parts.numbers();
}

std::vector<std::vector<std::uint32_t>> borders_of(const PlainSurface& surface) {
    std::vector<std::vector<std::uint32_t>> ends(surface.points.size());  // of border edges, by their starts
    const std::vector<Side> sides = sides_by_edge(surface.triangles);
    for (std::size_t s = 0; s < sides.size(); s += sides_of_edge(sides, s).size()) {
        if (sides_of_edge(sides, s).size() != 1) continue;
        const auto& [a, b, c] = surface.triangles[sides[s].triangle];
        const std::uint32_t low = sides[s].low, high = sides[s].high;
        const bool ascends = (a == low && b == high) || (b == low && c == high) || (c == low && a == high);
        ends[ascends ? low : high].push_back(ascends ? high : low);
    }
    std::vector<std::vector<std::uint32_t>> loops;
    for (std::uint32_t first = 0; first < ends.size(); ++first) {
        while (!ends[first].empty()) {
            std::vector<std::uint32_t> loop;
            for (std::uint32_t at = first; !ends[at].empty();) {
                loop.push_back(at);
                at = std::exchange(ends[at].back(), 0);
                ends[loop.back()].pop_back();
                if (at == first) break;
            }
            loops.push_back(std::move(loop));
        }
    }
    return loops;
}

float length_of(const PlainSurface& surface, const std::vector<std::uint32_t>& loop) {
    float length = 0;
    for (std::size_t k = 0; k < loop.size(); ++k)
        length += (surface.points[loop[(k + 1) % loop.size()]] - surface.points[loop[k]]).norm();
    return length;
}

void close_border(PlainSurface& surface, const std::vector<std::uint32_t>& loop) {
    const auto middle = static_cast<std::uint32_t>(surface.points.size());
    Vector3 sum = Vector3::Zero();
    for (const std::uint32_t p : loop) sum += surface.points[p];
    surface.points.push_back(sum / static_cast<float>(loop.size()));
    for (std::size_t k = 0; k < loop.size(); ++k)
        surface.triangles.push_back({loop[(k + 1) % loop.size()], loop[k], middle});
}

void refine(PlainSurface& surface, float longest) {
    for (bool is_done = false; !is_done;) {
        is_done = true;
        Middles middles(surface.points);
        std::vector<Triangle> refined;
        for (Triangle t : surface.triangles) {
            std::array<float, 3> lengths;  // of the edges from each corner to the next
            for (std::size_t c = 0; c < 3; ++c)
                lengths[c] = (surface.points[t[(c + 1) % 3]] - surface.points[t[c]]).norm();
            // The corners are turned such that the longest edge is the first.
            const auto turn = std::ranges::max_element(lengths) - lengths.begin();
            std::ranges::rotate(t, t.begin() + turn);
            std::ranges::rotate(lengths, lengths.begin() + turn);
            const auto& [a, b, c] = t;
            if (!(lengths[0] > longest)) {
                refined.push_back(t);
                continue;
            }
            is_done = false;
            const std::uint32_t ab = middles.of(a, b);
            if (lengths[1] > longest) {
                const std::uint32_t bc = middles.of(b, c);
                refined.insert(refined.end(), {{ab, b, bc}, {ab, bc, c}});
            } else {
                refined.push_back({ab, b, c});
            }
            if (lengths[2] > longest) {
                const std::uint32_t ca = middles.of(c, a);
                refined.insert(refined.end(), {{ab, c, ca}, {ab, ca, a}});
            } else {
                refined.push_back({ab, c, a});
            }
        }
        surface.triangles = std::move(refined);
    }
}

}  // namespace weft
