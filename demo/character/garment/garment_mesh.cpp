#include "demo/character/garment/garment_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "demo/character/garment/garment.h"
#include "engine/vector.h"

namespace weft::demo {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // the smaller index first

Edge edge_of(std::uint32_t a, std::uint32_t b) {
    return std::minmax(a, b);
}

/// For each vertex the first of those at the same position: a seam's two sides are one.
std::vector<std::uint32_t> welded(const Mesh& mesh) {
    std::map<std::array<float, 3>, std::uint32_t> first;
    std::vector<std::uint32_t> weld;
    for (const Vec3& p : mesh.positions) {
        const auto vertex = static_cast<std::uint32_t>(weld.size());
        weld.push_back(first.try_emplace({p.x, p.y, p.z}, vertex).first->second);
    }
    return weld;
}

/// Edges of one triangle, between welded vertices.
std::vector<Edge> border_edges(const Mesh& mesh) {
    const std::vector<std::uint32_t> weld = welded(mesh);
    std::map<Edge, int> triangles;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t c = 0; c < 3; ++c) ++triangles[edge_of(weld[t[c]], weld[t[(c + 1) % 3]])];
    }
    std::vector<Edge> border;
    for (const auto& [edge, count] : triangles) {
        if (count == 1) border.push_back(edge);
    }
    return border;
}

/// The connected parts of a set of edges, each as its vertices in ascending order.
std::vector<std::vector<std::uint32_t>> connected_parts(const std::vector<Edge>& edges) {
    std::map<std::uint32_t, std::uint32_t> parent;
    const auto root = [&](std::uint32_t vertex) {
        while (parent.at(vertex) != vertex) vertex = parent[vertex] = parent.at(parent.at(vertex));
        return vertex;
    };
    for (const auto& [a, b] : edges) {
        parent.try_emplace(a, a);
        parent.try_emplace(b, b);
        parent[root(a)] = root(b);
    }
    std::map<std::uint32_t, std::vector<std::uint32_t>> parts;
    for (const auto& [vertex, unused] : parent) parts[root(vertex)].push_back(vertex);

    std::vector<std::vector<std::uint32_t>> lists;
    for (auto& [unused, vertices] : parts) lists.push_back(std::move(vertices));
    return lists;
}

float mean_height(const Mesh& mesh, const std::vector<std::uint32_t>& vertices) {
    float sum = 0;
    for (const std::uint32_t vertex : vertices) sum += mesh.positions[vertex].y;
    return sum / static_cast<float>(vertices.size());
}

Vector3 extent_of(const Mesh& mesh) {
    Vector3 lower = to_vector(mesh.positions.front()), upper = lower;
    for (const Vec3& p : mesh.positions) {
        lower = lower.cwiseMin(to_vector(p));
        upper = upper.cwiseMax(to_vector(p));
    }
    return upper - lower;
}

/// True if the only opening goes round the whole mesh.
bool is_sheet(const Mesh& mesh, const std::vector<std::vector<std::uint32_t>>& openings) {
    if (openings.size() != 1) return false;
    Mesh border;
    for (const std::uint32_t vertex : openings.front()) border.positions.push_back(mesh.positions[vertex]);
    return (extent_of(border) - 0.9f * extent_of(mesh)).minCoeff() >= 0;
}

Vec3 middle(const Vec3& a, const Vec3& b) {
    return to_vec3(0.5f * (to_vector(a) + to_vector(b)));
}

Vec2 middle(const Vec2& a, const Vec2& b) {
    return {0.5f * (a.x + b.x), 0.5f * (a.y + b.y)};
}

}  // namespace

void stand_upright(Mesh& mesh, float lowest) {
    constexpr float huge = std::numeric_limits<float>::max();
    Vector3 lower = Vector3::Constant(huge), upper = Vector3::Constant(-huge);
    for (Vec3& p : mesh.positions) {
        p = {p.x, p.z, -p.y};
        lower = lower.cwiseMin(to_vector(p));
        upper = upper.cwiseMax(to_vector(p));
    }
    const Vector3 centre = 0.5f * (lower + upper);
    const Vector3 shift(-centre.x(), lowest - lower.y(), -centre.z());
    for (Vec3& p : mesh.positions) p = to_vec3(to_vector(p) + shift);
}

Mesh refined(const Mesh& mesh) {
    Mesh fine = mesh;
    fine.triangles.clear();
    // Seams stay welded: both their sides halve the same two positions, and floating-point addition commutes.
    std::map<Edge, std::uint32_t> middles;
    const auto middle_of = [&](std::uint32_t a, std::uint32_t b) {
        const auto [found, fresh] = middles.try_emplace(edge_of(a, b), fine.positions.size());
        if (fresh) {
            fine.positions.push_back(middle(mesh.positions[a], mesh.positions[b]));
            if (!mesh.pattern.empty()) fine.pattern.push_back(middle(mesh.pattern[a], mesh.pattern[b]));
            if (!mesh.texcoords.empty())
                fine.texcoords.push_back(middle(mesh.texcoords[a], mesh.texcoords[b]));
        }
        return found->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
        fine.triangles.insert(fine.triangles.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    return fine;
}

void refine(Garment& garment) {
    for (PaintedMap& painted : garment.maps) {
        Mesh carrier{.positions = garment.mesh.positions, .triangles = garment.mesh.triangles};
        for (const float value : painted.values) carrier.texcoords.push_back({value, 0});
        painted.values.clear();
        for (const Vec2& value : refined(carrier).texcoords) painted.values.push_back(value.x);
    }
    garment.mesh = refined(garment.mesh);
    garment.surface = refined(garment.surface);
}

std::vector<std::uint32_t> nearest_vertices(const Mesh& to, const Mesh& of) {
    std::vector<std::uint32_t> nearest;
    for (const Vec3& p : of.positions) {
        float least = std::numeric_limits<float>::max();
        std::uint32_t found = 0;
        for (std::uint32_t v = 0; v < to.positions.size(); ++v) {
            const float distance = (to_vector(to.positions[v]) - to_vector(p)).squaredNorm();
            if (distance < least) found = v;
            least = std::min(least, distance);
        }
        nearest.push_back(found);
    }
    return nearest;
}

float rest_length(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
    if (mesh.pattern.empty()) return (to_vector(mesh.positions[a]) - to_vector(mesh.positions[b])).norm();
    return std::hypot(mesh.pattern[a].x - mesh.pattern[b].x, mesh.pattern[a].y - mesh.pattern[b].y);
}

void drop_unfit_pattern(Mesh& mesh) {
    if (mesh.pattern.empty()) return;
    float in_space = 0, on_pattern = 0;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t a = t[corner], b = t[(corner + 1) % 3];
            in_space += (to_vector(mesh.positions[a]) - to_vector(mesh.positions[b])).norm();
            on_pattern += rest_length(mesh, a, b);
        }
    }
    if (!(on_pattern > 0.7f * in_space && on_pattern < 1.4f * in_space)) mesh.pattern.clear();
}

float guessed_unit(const Mesh& mesh) {
    constexpr float smallest = 0.2f, largest = 3;  // [m]
    const float size = extent_of(mesh).maxCoeff();
    if (!(size > 0)) return 1;
    for (const float unit : {1.0f, 0.01f, 0.001f, 0.0254f})
        if (unit * size >= smallest && unit * size <= largest) return unit;
    return 1 / size;
}

std::vector<std::uint32_t> topmost(const Mesh& mesh) {
    constexpr float flat = 0.05f;  // height over the longest side
    const Vector3 extent = extent_of(mesh);
    const float longest = extent.maxCoeff();
    const int axis = extent.y() > flat * longest ? 1 : extent.x() == longest ? 0 : 2;
    float most = to_vector(mesh.positions.front())[axis];
    for (const Vec3& p : mesh.positions) most = std::max(most, to_vector(p)[axis]);
    std::vector<std::uint32_t> top;
    for (std::uint32_t vertex = 0; vertex < mesh.positions.size(); ++vertex)
        if (to_vector(mesh.positions[vertex])[axis] >= most - 0.02f * extent[axis]) top.push_back(vertex);
    return top;
}

std::vector<std::uint32_t> border_vertices(const Mesh& mesh) {
    std::vector<std::uint32_t> all;
    for (const std::vector<std::uint32_t>& part : connected_parts(border_edges(mesh)))
        all.insert(all.end(), part.begin(), part.end());
    return all.empty() ? topmost(mesh) : all;
}

std::size_t count_openings(const Mesh& mesh) {
    return connected_parts(border_edges(mesh)).size();
}

std::vector<std::uint32_t> highest_opening(const Mesh& mesh) {
    const auto openings = connected_parts(border_edges(mesh));
    if (openings.empty() || is_sheet(mesh, openings)) return topmost(mesh);
    return *std::ranges::max_element(openings, {},
                                     [&](const auto& opening) { return mean_height(mesh, opening); });
}

std::vector<Vector3> outward_normals(const Mesh& mesh) {
    std::vector<Vector3> normals(mesh.positions.size(), Vector3::Zero());
    Vector3 middle = Vector3::Zero();
    for (const Vec3& p : mesh.positions) middle += to_vector(p) / static_cast<float>(mesh.positions.size());
    float outwards = 0;
    for (const Triangle& t : mesh.triangles) {
        const auto at = [&](std::size_t corner) { return to_vector(mesh.positions[t[corner]]); };
        const Vector3 area = (at(1) - at(0)).cross(at(2) - at(0));
        for (const std::uint32_t vertex : t) normals[vertex] += area;
        outwards += area.dot(Vector3(at(0).x() - middle.x(), 0, at(0).z() - middle.z()));
    }
    for (Vector3& normal : normals)
        normal = normal.isZero(0) ? Vector3(Vector3::UnitY())
                                  : Vector3((outwards < 0 ? -normal : normal).normalized());
    return normals;
}

}  // namespace weft::demo
