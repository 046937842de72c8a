#include "cloth/mesh/cook.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "cloth/mesh/cooking/ordering.h"
#include "cloth/mesh/rest/linear_bending.h"
#include "cloth/mesh/rest/slivers.h"
#include "cloth/mesh/rest/vertex_bending.h"
#include "cloth/mesh/topology/topology.h"
#include "engine/state_hash.h"

namespace weft {

namespace {

/// A spring before it is stored at both its ends. Invariant: a < b.
struct Spring {
    std::uint32_t a, b;
    SpringKind kind;
    float rest_length;  ///< [m]
};

Spring make_spring(std::uint32_t a, std::uint32_t b, SpringKind kind, double rest_length) {
    return {std::min(a, b), std::max(a, b), kind, static_cast<float>(rest_length)};
}

/// The vertex that a triangle has for a particle: at a seam each panel has its own.
std::uint32_t vertex_in(const Topology& topology, std::uint32_t triangle, std::uint32_t particle) {
    const Triangle& particles = topology.triangles[triangle];
    const auto corner = std::find(particles.begin(), particles.end(), particle) - particles.begin();
    return topology.corners[triangle][static_cast<std::size_t>(corner)];
}

double rest_distance(const Mesh& mesh, std::uint32_t vertex_a, std::uint32_t vertex_b) {
    return (rest_point(mesh, vertex_b) - rest_point(mesh, vertex_a)).norm();
}

/// The distance of two particles of a triangle in the triangle's own panel [m].
double rest_distance(const Mesh& mesh, const Topology& topology, std::uint32_t triangle, std::uint32_t a,
                     std::uint32_t b) {
    return rest_distance(mesh, vertex_in(topology, triangle, a), vertex_in(topology, triangle, b));
}

/// The mean of the edge's lengths in its triangles, which differ where a seam gathers one panel onto another.
double edge_length(const Mesh& mesh, const Topology& topology, const Edge& edge) {
    const auto [a, b] = edge.particles;
    const double first = rest_distance(mesh, topology, edge.triangles[0], a, b);
    if (edge.is_border()) return first;
    return 0.5 * (first + rest_distance(mesh, topology, edge.triangles[1], a, b));
}

/// Structural springs along all edges.
std::vector<Spring> springs_of_mesh(const Mesh& mesh, const Topology& topology) {
    std::vector<Spring> springs;
    springs.reserve(4 * topology.edges.size());
    for (const Edge& edge : topology.edges)
        springs.push_back(make_spring(edge.particles[0], edge.particles[1], SpringKind::structural,
                                      edge_length(mesh, topology, edge)));
    return springs;
}

/// Springs of a woven grid (Provot 1995): to neighbours along threads, across cells, and to second
/// neighbours, by which threads bend. Precondition: particle (row, column) is row * columns + column, and so
/// is its vertex.
std::vector<Spring> springs_of_grid(const Mesh& mesh) {
    struct Step {
        std::uint32_t rows;
        int columns;
        SpringKind kind;
    };
    static constexpr Step steps[] = {
        {0, 1, SpringKind::structural}, {1, 0, SpringKind::structural}, {1, 1, SpringKind::shear},
        {1, -1, SpringKind::shear},     {0, 2, SpringKind::bending},    {2, 0, SpringKind::bending},
    };
    std::vector<Spring> springs;
    springs.reserve(std::size(steps) * mesh.positions.size());
    for (std::uint32_t row = 0; row < mesh.rows; ++row) {
        for (std::uint32_t column = 0; column < mesh.columns; ++column) {
            for (const Step& step : steps) {
                const std::uint32_t other_row = row + step.rows;
                const std::int64_t other_column = std::int64_t{column} + step.columns;
                if (other_row >= mesh.rows || other_column < 0 || other_column >= mesh.columns) continue;
                const std::uint32_t a = row * mesh.columns + column;
                const std::uint32_t b = other_row * mesh.columns + static_cast<std::uint32_t>(other_column);
                springs.push_back(make_spring(a, b, step.kind, rest_distance(mesh, a, b)));
            }
        }
    }
    return springs;
}

/// Keeps one spring for each pair of particles: the first of those of the lowest kind.
void keep_one_per_pair(std::vector<Spring>& springs) {
    std::stable_sort(springs.begin(), springs.end(), [](const Spring& p, const Spring& q) {
        return std::tie(p.a, p.b, p.kind) < std::tie(q.a, q.b, q.kind);
    });
    const auto same_pair = [](const Spring& p, const Spring& q) { return p.a == q.a && p.b == q.b; };
    springs.erase(std::unique(springs.begin(), springs.end(), same_pair), springs.end());
}

void count_springs(std::span<const Spring> springs, ClothInfo& info) {
    double length = 0;
    for (const Spring& spring : springs) {
        switch (spring.kind) {
            case SpringKind::structural:
                ++info.structural_springs;
                length += static_cast<double>(spring.rest_length);
                break;
            case SpringKind::shear:
                ++info.shear_springs;
                break;
            case SpringKind::bending:
                break;
        }
    }
    info.mean_edge = static_cast<float>(length / info.structural_springs);
}

/// Turns counts[i + 1], the number of elements in row i, into the offsets at which rows start.
void accumulate_offsets(std::span<std::uint32_t> counts) {
    for (std::size_t i = 1; i < counts.size(); ++i) counts[i] += counts[i - 1];
}

/// Stores springs at both ends. Precondition: springs ascend by (a, b). Filling the far ends first leaves
/// every row ascending, since row i then gets its lower neighbours before its higher ones, each in order.
void store_springs(std::span<const Spring> springs, ClothModel& cloth) {
    cloth.spring_offsets = SharedBuffer<std::uint32_t>(cloth.particle_count + 1);
    cloth.neighbours = SharedBuffer<std::uint32_t>(2 * springs.size());
    cloth.rest_lengths = SharedBuffer<float>(2 * springs.size());
    cloth.kinds = SharedBuffer<SpringKind>(2 * springs.size());

    for (const Spring& spring : springs) {
        ++cloth.spring_offsets[spring.a + 1];
        ++cloth.spring_offsets[spring.b + 1];
    }
    accumulate_offsets(cloth.spring_offsets.span());

    std::vector<std::uint32_t> next(cloth.spring_offsets.data(),
                                    cloth.spring_offsets.data() + cloth.particle_count);
    const auto store = [&](std::uint32_t particle, std::uint32_t neighbour, const Spring& spring) {
        const std::uint32_t half_edge = next[particle]++;
        cloth.neighbours[half_edge] = neighbour;
        cloth.rest_lengths[half_edge] = spring.rest_length;
        cloth.kinds[half_edge] = spring.kind;
    };
    for (const Spring& spring : springs) store(spring.b, spring.a, spring);
    for (const Spring& spring : springs) store(spring.a, spring.b, spring);
}

void store_corners(ClothModel& cloth) {
    cloth.corner_offsets = SharedBuffer<std::uint32_t>(cloth.particle_count + 1);
    cloth.corner_triangles = SharedBuffer<std::uint32_t>(3 * cloth.triangles.size());
    for (const Triangle& triangle : cloth.triangles)
        for (const std::uint32_t particle : triangle) ++cloth.corner_offsets[particle + 1];
    accumulate_offsets(cloth.corner_offsets.span());

    std::vector<std::uint32_t> next(cloth.corner_offsets.data(),
                                    cloth.corner_offsets.data() + cloth.particle_count);
    for (std::uint32_t t = 0; t < cloth.triangles.size(); ++t)
        for (const std::uint32_t particle : cloth.triangles[t]) cloth.corner_triangles[next[particle]++] = t;
}

void store_rest_areas(const Mesh& mesh, const Topology& topology, ClothModel& cloth) {
    std::vector<double> areas(cloth.particle_count, 0.0);
    for (std::size_t t = 0; t < topology.triangles.size(); ++t) {
        const double third = rest_area(mesh, topology.corners[t]) / 3;
        for (const std::uint32_t particle : topology.triangles[t]) areas[particle] += third;
    }
    cloth.rest_area = SharedBuffer<float>(cloth.particle_count);
    for (std::uint32_t i = 0; i < cloth.particle_count; ++i)
        cloth.rest_area[i] = static_cast<float>(areas[i]);
}

void store_panel_sides(const Mesh& mesh, const Topology& topology, ClothModel& cloth) {
    if (mesh.pattern.empty()) return;
    std::vector<std::array<Vec2, 2>> sides;
    sides.reserve(topology.corners.size());
    for (const Triangle& corners : topology.corners) {
        const Vec2 &origin = mesh.pattern[corners[0]], &one = mesh.pattern[corners[1]],
                   &two = mesh.pattern[corners[2]];
        sides.push_back({{{one.x - origin.x, one.y - origin.y}, {two.x - origin.x, two.y - origin.y}}});
    }
    cloth.panel_sides = SharedBuffer<std::array<Vec2, 2>>(sides);
}

void store_texcoords(const Mesh& mesh, const Topology& topology, ClothModel& cloth) {
    if (mesh.texcoords.empty()) return;
    cloth.texcoords = SharedBuffer<Vec2>(mesh.texcoords);
    if (topology.corners != topology.triangles)
        cloth.vertex_triangles = SharedBuffer<Triangle>(topology.corners);
}

void store_positions(const Mesh& mesh, const Topology& topology, ClothModel& cloth) {
    cloth.positions = SharedBuffer<Vec4>(cloth.particle_count);
    for (std::uint32_t i = 0; i < cloth.particle_count; ++i) {
        const Vec3& p = mesh.positions[topology.first_vertices[i]];
        cloth.positions[i] = {p.x, p.y, p.z, 0};
    }
}

ClothInfo make_info(const Mesh& mesh, const Topology& topology) {
    ClothInfo info;
    info.vertices = static_cast<std::uint32_t>(mesh.positions.size());
    info.particles = topology.particle_count();
    info.welded_vertices = info.vertices - info.particles;
    info.triangles = static_cast<std::uint32_t>(topology.triangles.size());
    info.components = static_cast<std::uint32_t>(topology.component_offsets.size() - 1);
    info.border_edges = topology.border_edges;
    info.dropped_triangles = static_cast<std::uint32_t>(topology.dropped.size());
    info.turned_triangles = static_cast<std::uint32_t>(topology.turned.size());
    info.flipped_triangles = static_cast<std::uint32_t>(topology.flipped.size());
    info.misoriented_edges = topology.misoriented_edges;
    info.loose_particles = topology.loose_particles;
    return info;
}

/// Lists the repairs. Precondition: particles have not been renumbered.
CookReport make_report(const Topology& topology) {
    CookReport report{.welded = {},
                      .dropped = topology.dropped,
                      .turned = topology.turned,
                      .flipped = topology.flipped,
                      .softened = {},
                      .loose = {}};
    std::vector<bool> has_triangle(topology.particle_count());
    for (const Triangle& triangle : topology.triangles)
        for (const std::uint32_t particle : triangle) has_triangle[particle] = true;
    for (std::uint32_t vertex = 0; vertex < topology.vertex_to_particle.size(); ++vertex) {
        const std::uint32_t particle = topology.vertex_to_particle[vertex];
        const std::uint32_t first = topology.first_vertices[particle];
        if (first != vertex) report.welded.push_back({vertex, first});
        if (!has_triangle[particle]) report.loose.push_back(vertex);
    }
    return report;
}

/// Slivers that stayed, see stiffness_left().
std::vector<CookReport::Softened> softened_triangles(const ClothModel& cloth, const Topology& topology) {
    std::vector<CookReport::Softened> softened;
    for (std::uint32_t t = 0; t < cloth.triangles.size(); ++t)
        if (const double left = stiffness_left(rest_sides(cloth, t)); left < 1)
            softened.push_back({topology.sources[t], static_cast<float>(left)});
    return softened;
}

bool is_grid(const Mesh& mesh) {
    return mesh.rows > 0;
}  // check_mesh: rows and columns are zero together

/// The cell of a grid that a triangle halves, by its near left corner, and the corner that the triangle
/// leaves out: 0 near left, 1 near right, 2 far left, 3 far right. Nothing: the triangle halves no cell.
struct Half {
    std::uint32_t cell, left_out;
};
std::optional<Half> half_of_cell(const Mesh& mesh, const Triangle& triangle) {
    const std::uint32_t columns = mesh.columns;
    std::uint32_t row = mesh.rows, column = columns;
    for (const std::uint32_t vertex : triangle) {
        row = std::min(row, vertex / columns);
        column = std::min(column, vertex % columns);
    }
    std::uint32_t left_out = 0;  // 0 ^ 1 ^ 2 ^ 3 is 0, so that three corners leave the fourth
    for (const std::uint32_t vertex : triangle) {
        const std::uint32_t down = vertex / columns - row, across = vertex % columns - column;
        if (down > 1 || across > 1) return std::nullopt;
        left_out ^= 2 * down + across;
    }
    return Half{row * columns + column, left_out};
}

/// The number of the first triangle that is not the grid's; the count of triangles if there is none. Each
/// cell has two triangles, which leave out opposite corners.
std::size_t first_strange_triangle(const Mesh& mesh, std::span<const Triangle> triangles) {
    constexpr std::uint8_t none_yet = 4, full = 5;
    std::vector<std::uint8_t> left_out(mesh.positions.size(), none_yet);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const std::optional<Half> half = half_of_cell(mesh, triangles[t]);
        if (!half) return t;
        std::uint8_t& before = left_out[half->cell];
        if (before != none_yet && before != 3 - half->left_out) return t;
        before = before == none_yet ? static_cast<std::uint8_t>(half->left_out) : full;
    }
    return triangles.size();
}

/// Springs along the threads need every particle and every cell of the grid.
Result<void> check_grid(const Mesh& mesh, const Topology& topology) {
    const auto unlike_grid = [&](const std::string& what) {
        return Error{ErrorCode::invalid_mesh,
                     "the grid of Mesh::rows x Mesh::columns = " + std::to_string(mesh.rows) + " x " +
                         std::to_string(mesh.columns) + " " + what +
                         "; set both to 0 for a mesh that is not a grid"};
    };
    if (mesh.rows < 2 || mesh.columns < 2) return unlike_grid("has no cells: each must be at least 2");
    if (topology.particle_count() != mesh.positions.size())
        return unlike_grid("has " + std::to_string(mesh.positions.size()) + " vertices at only " +
                           std::to_string(topology.particle_count()) + " different positions");
    const std::uint64_t cells = std::uint64_t{mesh.rows - 1} * (mesh.columns - 1);
    if (topology.triangles.size() != 2 * cells)
        return unlike_grid("must have " + std::to_string(2 * cells) + " triangles of some area, not " +
                           std::to_string(topology.triangles.size()));
    const std::size_t strange = first_strange_triangle(mesh, topology.triangles);
    if (strange < topology.triangles.size()) {
        const auto [a, b, c] = topology.triangles[strange];
        return unlike_grid(
            "has vertex (row, column) at row * columns + column, and two triangles in each of "
            "its cells: the triangle of vertices " +
            std::to_string(a) + ", " + std::to_string(b) + " and " + std::to_string(c) +
            " is not one of them");
    }
    return {};
}

/// Stores springs and bending's weights. `springs` are those of the membrane; for a grid, all.
void store_bending_among(std::vector<Spring> springs, ClothModel& cloth) {
    if (cloth.rows > 0) {
        store_springs(springs, cloth);
        const std::vector<BendingElement> bending = linear_bending(cloth);
        cloth.info.bending_elements = static_cast<std::uint32_t>(bending.size());
        store_bending(bending, cloth);
        return;
    }
    const VertexBending bending = vertex_bending(cloth);
    for (const BendingPair& pair : bending.pairs)
        springs.push_back(make_spring(pair.i, pair.j, SpringKind::bending, pair.length));
    keep_one_per_pair(springs);
    store_springs(springs, cloth);
    cloth.info.bending_elements = bending.elements;
    store_bending(bending, cloth);
}

}  // namespace

Result<ClothModel> cook(const Mesh& mesh, float bending_ratio, CookReport* report, const Progress& progress) {
    Result<Topology> built = build_topology(mesh);
    if (!built) return built.error();
    progress.reach(Progress::welded);
    Topology& topology = *built;
    if (is_grid(mesh))
        if (Result<void> grid = check_grid(mesh, topology); !grid) return grid.error();
    if (report != nullptr) *report = make_report(topology);
    // Rows of a grid are in order already: neighbours lie at the same few distances from all particles.
    if (!is_grid(mesh)) renumber(topology, memory_order(topology));
    progress.reach(Progress::ordered);

    std::vector<Spring> springs = is_grid(mesh) ? springs_of_grid(mesh) : springs_of_mesh(mesh, topology);
    keep_one_per_pair(springs);
    progress.reach(Progress::joined);

    ClothModel cloth;
    cloth.particle_count = topology.particle_count();
    cloth.rows = mesh.rows;
    cloth.columns = mesh.columns;
    cloth.bending_ratio = bending_ratio;
    cloth.info = make_info(mesh, topology);
    count_springs(springs, cloth.info);
    store_positions(mesh, topology, cloth);
    store_rest_areas(mesh, topology, cloth);
    store_panel_sides(mesh, topology, cloth);
    cloth.triangles = SharedBuffer<Triangle>(topology.triangles);
    store_corners(cloth);
    cloth.component_offsets = SharedBuffer<std::uint32_t>(topology.component_offsets);
    cloth.component_particles = SharedBuffer<std::uint32_t>(topology.component_particles);
    cloth.vertex_to_particle = SharedBuffer<std::uint32_t>(topology.vertex_to_particle);
    store_texcoords(mesh, topology, cloth);
    const std::vector<CookReport::Softened> softened = softened_triangles(cloth, topology);
    cloth.info.softened_triangles = static_cast<std::uint32_t>(softened.size());
    if (report != nullptr) report->softened = softened;
    progress.reach(Progress::stored);
    store_bending_among(std::move(springs), cloth);
    cloth.fingerprint = fingerprint_of(cloth);
    progress.reach(Progress::modelled);
    return cloth;
}

ClothModel with_bending_ratio(ClothModel model, float bending_ratio) {
    if (model.bending_ratio == bending_ratio) return model;
    model.bending_ratio = bending_ratio;
    std::vector<Spring> springs;
    for (std::uint32_t i = 0; i < model.particle_count; ++i)
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e)
            if (i < model.neighbours[e] && (model.rows > 0 || model.kinds[e] != SpringKind::bending))
                springs.push_back({i, model.neighbours[e], model.kinds[e], model.rest_lengths[e]});
    store_bending_among(std::move(springs), model);
    return model;
}

std::uint32_t fingerprint_of(const ClothModel& model) {
    StateHash hash;
    hash.add(model.triangles.span());
    hash.add(model.vertex_to_particle.span());
    return static_cast<std::uint32_t>(hash.value());
}

std::uint32_t half_edge_between(const ClothModel& model, std::uint32_t i, std::uint32_t j) {
    constexpr std::uint32_t few = 32;
    const std::uint32_t begin = model.spring_offsets[i], end = model.spring_offsets[i + 1];
    // The half-edge exists, except in a corrupt file.
    const auto last = static_cast<std::uint32_t>(model.neighbours.size()) - 1;
    const std::uint32_t* const neighbours = model.neighbours.data();
    if (end - begin > few)
        return std::min(last, static_cast<std::uint32_t>(
                                  std::lower_bound(neighbours + begin, neighbours + end, j) - neighbours));
    // In short rows counting is faster than bisection, whose branches cannot be predicted.
    std::uint32_t before = 0;
    for (std::uint32_t e = begin; e < end; ++e) before += neighbours[e] < j ? 1 : 0;
    return std::min(last, begin + before);
}

}  // namespace weft
