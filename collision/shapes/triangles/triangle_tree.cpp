#include "collision/shapes/triangles/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "collision/shapes/triangles/ranges.h"
#include "engine/error_text.h"

namespace weft {

namespace {

constexpr std::size_t most_triangles = std::size_t{1} << 22;
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

Error invalid(const char* name, const std::string& rest) {
    return {ErrorCode::invalid_argument, name + rest};
}

Result<void> validate_vertices(const char* name, std::span<const Vec3> vertices) {
    for (std::size_t v = 0; v < vertices.size(); ++v)
        if (!(to_vector(vertices[v]).cwiseAbs().maxCoeff() <= farthest_collider) || !is_finite(vertices[v]))
            return out_of_range(name + std::string("::vertices[") + std::to_string(v) + "]", vertices[v],
                                "from -1e5 to 1e5 m on each axis");
    return {};
}

/// For each vertex, the first vertex at its position.
std::vector<std::uint32_t> first_at_position(std::span<const Vec3> vertices) {
    std::vector<std::uint32_t> order(vertices.size()), first(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t v) {
        return std::array{vertices[v].x + 0.0f, vertices[v].y + 0.0f, vertices[v].z + 0.0f};
    };
    std::ranges::sort(
        order, [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    for (std::size_t k = 0; k < order.size(); ++k)
        first[order[k]] = k > 0 && key(order[k]) == key(order[k - 1]) ? first[order[k - 1]] : order[k];
    return first;
}

struct DirectedEdge {
    std::uint32_t from, to, triangle, corner;
};

double volume_of(std::span<const Vec3> vertices, std::span<const Corners> triangles) {
    const auto at = [&](std::uint32_t v) -> Eigen::Vector3d {
        return (to_vector(vertices[v]) - to_vector(vertices[triangles[0][0]])).cast<double>();
    };
    double volume = 0;
    for (const Corners& t : triangles) volume += at(t[0]).dot(at(t[1]).cross(at(t[2]))) / 6;
    return volume;
}

}  // namespace

Result<TriangleTree> TriangleTree::make(const char* name, std::span<const Vec3> vertices,
                                        std::span<const Corners> triangles, bool closed) {
    if (triangles.empty() || triangles.size() > most_triangles)
        return invalid(
            name, "::triangles has " + std::to_string(triangles.size()) + "; it must have from 1 to 2^22");
    if (auto valid = validate_vertices(name, vertices); !valid) return valid.error();
    TriangleTree made;
    made.closed_ = closed;
    made.vertices_.assign(vertices.begin(), vertices.end());
    made.representative_ = first_at_position(vertices);
    made.triangles_.assign(triangles.begin(), triangles.end());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::uint32_t& v : made.triangles_[t]) {
            if (v >= vertices.size())
                return invalid(name, "::triangles[" + std::to_string(t) + "] has the vertex " +
                                         std::to_string(v) + "; there are " +
                                         std::to_string(vertices.size()));
            v = made.representative_[v];
        }
        const Corners& c = made.triangles_[t];
        if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
            return invalid(
                name, "::triangles[" + std::to_string(t) + "] has two corners at one position; leave it out");
    }
    if (auto sound = made.find_neighbours(name); !sound) return sound.error();
    if (closed && !(volume_of(vertices, made.triangles_) > 0))
        return invalid(name, " is inside out; wind its triangles counter-clockwise as seen from outside");
    made.build();
    (void)made.find_neighbours(name);  // again: build() has reordered the triangles
    made.fit();
    return made;
}

Result<void> TriangleTree::find_neighbours(const char* name) {
    std::vector<DirectedEdge> edges;
    edges.reserve(3 * triangles_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k)
            edges.push_back({triangles_[t][k], triangles_[t][(k + 1) % 3], t, k});
    const auto key = [](const DirectedEdge& e) {
        return std::array{std::min(e.from, e.to), std::max(e.from, e.to), e.from, e.triangle};
    };
    std::ranges::sort(edges, {}, key);
    neighbours_.assign(triangles_.size(), {none, none, none});
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (end < edges.size() && key(edges[end])[0] == key(edges[i])[0] &&
               key(edges[end])[1] == key(edges[i])[1])
            ++end;
        const bool is_pair = end - i == 2 && edges[i].from != edges[i + 1].from;
        if (is_pair) {
            neighbours_[edges[i].triangle][edges[i].corner] = edges[i + 1].triangle;
            neighbours_[edges[i + 1].triangle][edges[i + 1].corner] = edges[i].triangle;
        } else if (closed_) {
            const std::string edge = "the edge of vertices " + std::to_string(edges[i].from) + " and " +
                                     std::to_string(edges[i].to);
            if (end - i == 1)
                return invalid(
                    name, " is open: " + edge + " has one triangle; close it, or say that it is not closed");
            return invalid(
                name, ": " + edge + " has " + std::to_string(end - i) +
                          " triangles that do not follow each other; a closed mesh has two, wound alike");
        }
        i = end;
    }
    return {};
}

// Splits near the median of the triangles' centroids, along the longest side of the centroids' bounding box,
// so that all leaves but the last are full.
void TriangleTree::build() {
    const auto middle = [&](const Corners& t) -> Vector3 {
        return (to_vector(vertices_[t[0]]) + to_vector(vertices_[t[1]]) + to_vector(vertices_[t[2]])) / 3;
    };
    nodes_.assign(1, {{}, {}, 0, static_cast<std::uint32_t>(triangles_.size())});
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const std::uint32_t first = nodes_[n].first, count = nodes_[n].count;
        if (count <= TriangleLeaf::size) continue;
        const std::uint32_t half =
            (count + TriangleLeaf::size - 1) / TriangleLeaf::size / 2 * TriangleLeaf::size;
        Eigen::AlignedBox3f middles;
        for (std::uint32_t t = first; t < first + count; ++t) middles.extend(middle(triangles_[t]));
        int axis = 0;
        middles.sizes().maxCoeff(&axis);
        const auto begin = triangles_.begin() + first;
        std::nth_element(begin, begin + half, begin + count, [&](const Corners& a, const Corners& b) {
            const float of_a = middle(a)[axis], of_b = middle(b)[axis];
            return of_a != of_b ? of_a < of_b : a < b;
        });
        nodes_[n].first = static_cast<std::uint32_t>(nodes_.size());
        nodes_[n].count = 0;
        nodes_.push_back({{}, {}, first, half});
        nodes_.push_back({{}, {}, first + half, count - half});
    }
    leaves_.resize((triangles_.size() + TriangleLeaf::size - 1) / TriangleLeaf::size);
    face_normals_.resize(triangles_.size());
    vertex_normals_.resize(vertices_.size());
}

// Nodes are fitted from the last to the first, because children stand after their parents.
void TriangleTree::fit() {
    fit_leaves(vertices_, triangles_, leaves_, face_normals_, vertex_normals_);
    float largest = 0;
    for (const Vec3& v : vertices_) largest = std::max(largest, to_vector(v).cwiseAbs().maxCoeff());
    const Vector3 slack = Vector3::Constant(2e-6f * largest);
    for (std::size_t n = nodes_.size(); n-- > 0;) {
        Node& node = nodes_[n];
        Eigen::AlignedBox3f box;
        for (std::uint32_t t = node.first; t < node.first + node.count; ++t)
            for (const std::uint32_t v : triangles_[t]) box.extend(to_vector(vertices_[v]));
        if (node.count > 0) {
            box = {box.min() - slack, box.max() + slack};
        } else {
            for (const Node& child : {nodes_[node.first], nodes_[node.first + 1]})
                box.extend(Eigen::AlignedBox3f(to_vector(child.lower), to_vector(child.upper)));
        }
        node.lower = to_vec3(box.min());
        node.upper = to_vec3(box.max());
    }
}

Vector3 TriangleTree::pseudo_normal(std::uint32_t triangle, const std::array<float, 3>& weights) const {
    const Corners& corners = triangles_[triangle];
    const Vector3 face = to_vector(face_normals_[triangle]);
    int zeros = 0;
    for (const float w : weights) zeros += w < on_border ? 1 : 0;
    for (std::uint32_t k = 0; k < 3; ++k) {
        if (zeros == 2 && !(weights[k] < on_border)) return to_vector(vertex_normals_[corners[k]]);
        if (zeros != 1 || !(weights[(k + 2) % 3] < on_border)) continue;
        const std::uint32_t across = neighbours_[triangle][k];
        return across == none ? face : Vector3(face + to_vector(face_normals_[across]));
    }
    return face;
}

Result<void> TriangleTree::validate_deform(const char* name, std::span<const Vec3> vertices) const {
    if (vertices.size() != vertices_.size())
        return invalid(name, "'s vertices are " + std::to_string(vertices.size()) + "; the mesh has " +
                                 std::to_string(vertices_.size()));
    if (auto valid = validate_vertices(name, vertices); !valid) return valid;
    if (closed_ && !(volume_of(vertices, triangles_) > 0))
        return invalid(name, "'s vertices turn the mesh inside out");
    return {};
}

void TriangleTree::deform(std::span<const Vec3> vertices, bool again) {
    displacements_.resize(vertices_.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const Vec3& to = vertices[representative_[v]];
        const Vector3 before = again ? to_vector(displacements_[v]) : Vector3(Vector3::Zero());
        displacements_[v] = to_vec3(before + (to_vector(to) - to_vector(vertices_[v])));
        vertices_[v] = to;
    }
    fit();
}

void TriangleTree::put_back(std::span<const Vec3> vertices, std::span<const Vec3> displacements) {
    std::ranges::copy(vertices, vertices_.begin());
    displacements_.assign(displacements.begin(), displacements.end());
    fit();
}

Eigen::AlignedBox3f TriangleTree::box() const {
    return {to_vector(nodes_[0].lower), to_vector(nodes_[0].upper)};
}

std::size_t TriangleTree::bytes() const noexcept {
    const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
    return of(vertices_) + of(displacements_) + of(representative_) + of(triangles_) + of(neighbours_) +
           of(face_normals_) + of(vertex_normals_) + of(nodes_) + of(leaves_);
}

}  // namespace weft
