#include "cloth/mesh/topology/topology.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numeric>
#include <string>
#include <tuple>

#include <Eigen/Geometry>

#include "cloth/mesh/coordinates.h"
#include "cloth/mesh/mesh_limits.h"
#include "cloth/mesh/topology/flip_slivers.h"
#include "cloth/mesh/topology/repair.h"
#include "engine/error_text.h"
#include "engine/joined_sets.h"
#include "engine/vector.h"

namespace weft {

namespace {

template <std::integral Integer>
std::string text(Integer value) {
    return std::to_string(value);
}

std::string text(float value) {
    return number_text(static_cast<double>(value));
}

std::string text(const Vec2& p) {
    return std::string("(") + text(p.x) + ", " + text(p.y) + ")";
}

std::string text(const Vec3& p) {
    return std::string("(") + text(p.x) + ", " + text(p.y) + ", " + text(p.z) + ")";
}

Error invalid_mesh(std::string message) {
    return {ErrorCode::invalid_mesh, std::move(message)};
}

/// False for not-a-number, too.
bool usable(float coordinate) {
    return std::abs(coordinate) <= runaway_distance;
}

template <class Point>
Error unusable_point(const char* array, std::size_t vertex, const Point& value) {
    return invalid_mesh("Mesh::" + std::string(array) + "[" + text(vertex) + "] is " + text(value) +
                        "; every coordinate must be finite and within " + text(runaway_distance) +
                        " m of 0; coordinates are in metres, not in millimetres");
}

Error wrong_size(const char* array, std::size_t size, std::size_t vertices) {
    return invalid_mesh("Mesh::" + std::string(array) + " has " + text(size) +
                        " elements; it must have one per vertex (" + text(vertices) + ") or none");
}

Result<void> check_sizes(const Mesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    if (vertices > most_vertices)
        return invalid_mesh("the mesh has " + text(vertices) + " vertices; at most " + text(most_vertices) +
                            " make a cloth");
    if (mesh.triangles.empty())
        return invalid_mesh("the mesh has " + text(vertices) +
                            " vertices and no triangles; a cloth needs at least one");
    if (mesh.triangles.size() > most_triangles)
        return invalid_mesh("the mesh has " + text(mesh.triangles.size()) + " triangles; at most " +
                            text(most_triangles) + " make a cloth");
    if (!mesh.pattern.empty() && mesh.pattern.size() != vertices)
        return wrong_size("pattern", mesh.pattern.size(), vertices);
    if (!mesh.texcoords.empty() && mesh.texcoords.size() != vertices)
        return wrong_size("texcoords", mesh.texcoords.size(), vertices);
    if (!mesh.welds.empty() && mesh.welds.size() != vertices)
        return wrong_size("welds", mesh.welds.size(), vertices);
    const std::uint64_t grid = std::uint64_t{mesh.rows} * mesh.columns;
    if ((mesh.rows != 0 || mesh.columns != 0) && grid != vertices)
        return invalid_mesh("Mesh::rows x Mesh::columns is " + text(mesh.rows) + " x " + text(mesh.columns) +
                            " = " + text(grid) + ", but there are " + text(vertices) +
                            " vertices; set both to 0 for a mesh that is not a grid");
    return {};
}

Result<void> check_points(const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3& p = mesh.positions[i];
        if (!usable(p.x) || !usable(p.y) || !usable(p.z)) return unusable_point("positions", i, p);
    }
    for (std::size_t i = 0; i < mesh.pattern.size(); ++i) {
        const Vec2& p = mesh.pattern[i];
        if (!usable(p.x) || !usable(p.y)) return unusable_point("pattern", i, p);
    }
    for (std::size_t i = 0; i < mesh.texcoords.size(); ++i) {
        const Vec2& p = mesh.texcoords[i];
        if (!std::isfinite(p.x) || !std::isfinite(p.y))
            return invalid_mesh("Mesh::texcoords[" + text(i) + "] is " + text(p) +
                                "; both coordinates must be finite");
    }
    return {};
}

Result<void> check_indices(const Mesh& mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = mesh.triangles[t][corner];
            if (vertex >= mesh.positions.size())
                return invalid_mesh("corner " + text(corner) + " of triangle " + text(t) + " is vertex " +
                                    text(vertex) + "; the mesh has " + text(mesh.positions.size()) +
                                    " vertices, which are counted from 0");
        }
    }
    return {};
}

Result<void> check_welds(const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.welds.size(); ++i) {
        const std::uint32_t first = mesh.welds[i];
        if (first > i || mesh.welds[first] != first)
            return invalid_mesh("Mesh::welds[" + text(i) + "] is " + text(first) +
                                "; it must be the first vertex of its particle, itself or one before it");
        const Vec3 &p = mesh.positions[i], &q = mesh.positions[first];
        if (!(p.x == q.x && p.y == q.y && p.z == q.z))
            return invalid_mesh("Mesh::welds makes vertex " + text(i) + " one with vertex " + text(first) +
                                ", which lies elsewhere; vertices of one particle have one position");
    }
    return {};
}

/// The particle of each vertex: by Mesh::welds, or by weld_open_edges() where that is empty.
std::vector<std::uint32_t> particles_of(const Mesh& mesh) {
    if (mesh.welds.empty()) return weld_open_edges(mesh);
    std::vector<std::uint32_t> numbers(mesh.welds.size());
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < numbers.size(); ++i)
        numbers[i] = mesh.welds[i] == i ? next++ : numbers[mesh.welds[i]];
    return numbers;
}

void store_edges(std::span<const Side> sides, Topology& topology) {
    topology.edges.clear();
    topology.border_edges = 0;
    topology.edges.reserve(sides.size() / 2);
    for (std::size_t begin = 0; begin < sides.size();) {
        const std::span<const Side> same = sides_of_edge(sides, begin);
        begin += same.size();
        Edge edge{
            {same[0].low, same[0].high}, {same[0].triangle, Edge::none}, {same[0].opposite, Edge::none}};
        if (same.size() == 2) {
            edge.triangles[1] = same[1].triangle;
            edge.opposites[1] = same[1].opposite;
        } else {
            ++topology.border_edges;
        }
        topology.edges.push_back(edge);
    }
}

/// Keeps the mesh's triangles that have an area.
void keep_triangles(const Mesh& mesh, Topology& topology) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle& corners = mesh.triangles[t];
        const Triangle particles{topology.vertex_to_particle[corners[0]],
                                 topology.vertex_to_particle[corners[1]],
                                 topology.vertex_to_particle[corners[2]]};
        const bool repeats =
            particles[0] == particles[1] || particles[1] == particles[2] || particles[2] == particles[0];
        if (repeats || !has_area(mesh, corners)) {
            topology.dropped.push_back({t, DropReason::no_area});
            continue;
        }
        topology.triangles.push_back(particles);
        topology.corners.push_back(corners);
        topology.sources.push_back(t);
    }
}

}  // namespace

void build_edges(Topology& topology) {
    store_edges(sides_by_edge(topology.triangles), topology);
}

void build_components(Topology& topology) {
    topology.component_offsets.clear();
    JoinedSets components(topology.particle_count());
    for (const Edge& edge : topology.edges) components.join(edge.particles[0], edge.particles[1]);
    components.finish();
    const std::span<const std::uint32_t> roots = components.firsts();
    topology.component_particles.resize(roots.size());
    std::iota(topology.component_particles.begin(), topology.component_particles.end(), 0u);
    std::stable_sort(topology.component_particles.begin(), topology.component_particles.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return roots[a] < roots[b]; });
    for (std::uint32_t i = 0; i < roots.size(); ++i)
        if (roots[topology.component_particles[i]] == topology.component_particles[i])
            topology.component_offsets.push_back(i);
    topology.component_offsets.push_back(topology.particle_count());
}

Result<void> check_mesh(const Mesh& mesh) {
    if (Result<void> sizes = check_sizes(mesh); !sizes) return sizes;
    if (Result<void> points = check_points(mesh); !points) return points;
    if (Result<void> welds = check_welds(mesh); !welds) return welds;
    return check_indices(mesh);
}

Eigen::Vector3d rest_point(const Mesh& mesh, std::uint32_t vertex) {
    if (!mesh.pattern.empty())
        return Eigen::Vector3f(mesh.pattern[vertex].x, mesh.pattern[vertex].y, 0).cast<double>();
    return to_vector(mesh.positions[vertex]).cast<double>();
}

double rest_area(const Mesh& mesh, const Triangle& vertices) {
    const Eigen::Vector3d a = rest_point(mesh, vertices[0]);
    return 0.5 * (rest_point(mesh, vertices[1]) - a).cross(rest_point(mesh, vertices[2]) - a).norm();
}

bool has_area(const Mesh& mesh, const Triangle& vertices) {
    const Eigen::Vector3d a = rest_point(mesh, vertices[0]);
    const Eigen::Vector3d b = rest_point(mesh, vertices[1]);
    const Eigen::Vector3d c = rest_point(mesh, vertices[2]);
    const double longest_squared =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    const double area = rest_area(mesh, vertices);
    return 2 * area > least_relative_height * longest_squared && area >= least_area;
}

std::vector<std::uint32_t> weld(std::span<const Vec3> positions) {
    const auto key = [&](std::uint32_t i) {
        return std::tie(positions[i].x, positions[i].y, positions[i].z);
    };
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto key_a = key(a), key_b = key(b);
        return key_a < key_b || (key_a == key_b && a < b);
    });

    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }

    std::vector<std::uint32_t> numbers(positions.size());
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        numbers[i] = first[i] == i ? next++ : numbers[first[i]];
    return numbers;
}

const Edge* find_edge(const Topology& topology, std::uint32_t a, std::uint32_t b) {
    const std::array<std::uint32_t, 2> ends{std::min(a, b), std::max(a, b)};
    const auto at = std::ranges::lower_bound(topology.edges, ends, {}, &Edge::particles);
    return at != topology.edges.end() && at->particles == ends ? &*at : nullptr;
}

Result<Topology> build_topology(const Mesh& mesh) {
    if (Result<void> check = check_mesh(mesh); !check) return check.error();

    Topology topology;
    topology.vertex_to_particle = particles_of(mesh);
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i)
        if (topology.vertex_to_particle[i] == topology.particle_count()) topology.first_vertices.push_back(i);

    keep_triangles(mesh, topology);
    if (topology.triangles.empty())
        return invalid_mesh(
            "all " + text(mesh.triangles.size()) + " triangles of the mesh have no area in its " +
            (mesh.pattern.empty() ? "positions" : "pattern") + "; a cloth needs at least one that has");
    store_edges(leave_out_crowding(topology), topology);
    turn_alike(mesh, topology);
    if (mesh.rows == 0) flip_slivers(mesh, topology);
    build_components(topology);
    topology.loose_particles = static_cast<std::uint32_t>(std::ranges::count(triangle_counts(topology), 0u));
    return topology;
}

}  // namespace weft
