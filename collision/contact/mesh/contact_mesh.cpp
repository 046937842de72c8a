#include "collision/contact/mesh/contact_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "collision/contact/mesh/surface_order.h"
#include "collision/search/patches.h"
#include "engine/memory/list_checks.h"
#include "engine/vector.h"

namespace weft {

namespace {

using Triangle = ContactMesh::Triangle;
using Edge = ContactMesh::Edge;

std::vector<Triangle> with_three_corners(std::span<const Triangle> triangles) {
    std::vector<Triangle> result;
    result.reserve(triangles.size());
    std::ranges::copy_if(triangles, std::back_inserter(result),
                         [](const Triangle& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; });
    return result;
}

std::vector<Edge> unique_edges(std::span<const Triangle> triangles) {
    std::vector<Edge> edges;
    edges.reserve(3 * triangles.size());
    for (const Triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
            edges.push_back({low, high});
        }
    std::ranges::sort(edges);
    const auto spare = std::ranges::unique(edges);
    edges.erase(spare.begin(), spare.end());
    return edges;
}

/// The least height of these triangles [m].
float least_height_of(std::span<const Vec4> at, std::span<const Triangle> triangles) {
    float least = std::numeric_limits<float>::max();
    for (const auto& [i, j, k] : triangles) {
        const Vector3 a = xyz(at[i]), b = xyz(at[j]), c = xyz(at[k]);
        const float longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        least = std::min(least, longest > 0 ? (b - a).cross(c - a).norm() / longest : 0.0f);
    }
    return least;
}

/// The particles that are corners of triangles.
std::vector<std::uint32_t> vertices_of(std::size_t particles, std::span<const Triangle> triangles) {
    std::vector<bool> is_vertex(particles);
    for (const Triangle& t : triangles)
        for (const std::uint32_t i : t) is_vertex[i] = true;
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t i = 0; i < is_vertex.size(); ++i)
        if (is_vertex[i]) vertices.push_back(i);
    return vertices;
}

std::vector<Vec4> finite(std::span<const Vec4> positions) {
    std::vector<Vec4> result(positions.begin(), positions.end());
    for (Vec4& p : result)
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) p = {};
    return result;
}

/// Features of one kind, by clusters of vertices: those of cluster c are [starts[c], starts[c + 1]) of
/// `order`. A feature goes to the lowest of its corners' clusters. In a grid of square clusters, a cluster
/// has its own features and those towards higher neighbours, so that few corners belong to others.
struct Shares {
    std::vector<std::uint32_t> starts, order;

    template <class Feature>
    Shares(std::span<const Feature> features, std::span<const std::uint32_t> cluster_of,
           std::uint32_t clusters)
        : starts(clusters + 1), order(features.size()) {
        const auto owner = [&](const Feature& feature) {
            std::uint32_t lowest = cluster_of[feature[0]];
            for (const std::uint32_t i : feature) lowest = std::min(lowest, cluster_of[i]);
            return lowest;
        };
        for (const Feature& feature : features) ++starts[owner(feature) + 1];
        for (std::uint32_t c = 0; c < clusters; ++c) starts[c + 1] += starts[c];
        std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
        for (std::uint32_t f = 0; f < features.size(); ++f) order[next[owner(features[f])]++] = f;
    }
};

/// Fills the slots of one kind of feature.
template <std::uint32_t corner_count>
class SlotFiller {
  public:
    /// Begins a patch's span; pads the last group.
    SlotSpan begin() {
        for (auto& corner : corners_)
            while (corner.size() % 16 != 0) corner.push_back(corner.back());
        return {static_cast<std::uint32_t>(corners_[0].size()), 0};
    }
    void add(SlotSpan& span, const std::array<std::uint32_t, corner_count>& feature) {
        for (std::uint32_t k = 0; k < corner_count; ++k) corners_[k].push_back(feature[k]);
        ++span.count;
    }
    FeatureSlots<corner_count> finish() {
        begin();
        FeatureSlots<corner_count> slots;
        for (std::uint32_t k = 0; k < corner_count; ++k)
            slots.corners[k] = SharedBuffer<std::uint32_t>(corners_[k]);
        return slots;
    }

  private:
    std::array<std::vector<std::uint32_t>, corner_count> corners_;
};

/// Finds the corners of all features of each patch.
FeatureSlots<1> share_corners(std::span<ContactPatch> patches, const FeatureSlots<1>& vertices,
                              const FeatureSlots<3>& triangles, const FeatureSlots<2>& edges) {
    SlotFiller<1> slots;
    std::vector<std::uint32_t> corners;
    for (ContactPatch& patch : patches) {
        const auto take = [&](const auto& features, const SlotSpan& span) {
            for (const auto& corner : features.corners)
                corners.insert(corners.end(), corner.data() + span.first,
                               corner.data() + span.first + span.count);
        };
        corners.clear();
        take(vertices, patch.vertices);
        take(triangles, patch.triangles);
        take(edges, patch.edges);
        std::ranges::sort(corners);
        const auto spare = std::ranges::unique(corners);
        corners.erase(spare.begin(), spare.end());
        patch.corners = slots.begin();
        for (const std::uint32_t i : corners) slots.add(patch.corners, {i});
    }
    return slots.finish();
}

}  // namespace

ContactMesh::ContactMesh(std::span<const Vec4> rest_positions, std::span<const Triangle> triangles)
    : particles_(static_cast<std::uint32_t>(rest_positions.size())) {
    triangles_ = SharedBuffer<Triangle>(with_three_corners(triangles));
    edges_ = SharedBuffer<Edge>(unique_edges(this->triangles()));
    find_corners();

    std::vector<std::uint32_t> vertices = vertices_of(rest_positions.size(), this->triangles());
    const std::vector<Vec4> places = finite(rest_positions);
    least_height_ = least_height_of(places, this->triangles());
    order_in_patches(vertices, places);
    share_out(rest_positions, vertices);
    if (flat_rest_.has_all_triangles()) return;
    // Patches of cloth that is folded or closed at rest are close in space, but not along the cloth. They
    // soon spread wide and overlap many others.
    order_along_surface(vertices, edges(), places);
    share_out(rest_positions, vertices);
}

void ContactMesh::share_out(std::span<const Vec4> rest_positions, std::span<const std::uint32_t> vertices) {
    std::vector<std::uint32_t> cluster_of(rest_positions.size());
    for (std::uint32_t k = 0; k < vertices.size(); ++k)
        cluster_of[vertices[k]] = k / ContactPatch::most_vertices;
    const auto clusters = static_cast<std::uint32_t>((vertices.size() + ContactPatch::most_vertices - 1) /
                                                     ContactPatch::most_vertices);
    const Shares shares_of_triangles(triangles(), cluster_of, clusters);
    const Shares shares_of_edges(edges(), cluster_of, clusters);

    std::vector<ContactPatch> patches;
    SlotFiller<1> vertex_slots;
    SlotFiller<3> triangle_slots;
    SlotFiller<2> edge_slots;
    const auto begin_patch = [&] {
        patches.push_back({vertex_slots.begin(), triangle_slots.begin(), edge_slots.begin(), {}});
    };
    for (std::uint32_t c = 0; c < clusters; ++c) {
        begin_patch();
        const std::size_t end = std::min<std::size_t>(vertices.size(), (c + 1) * ContactPatch::most_vertices);
        for (std::size_t k = c * ContactPatch::most_vertices; k < end; ++k)
            vertex_slots.add(patches.back().vertices, {vertices[k]});
        // A cluster at a vertex of very many triangles takes several patches.
        for (std::uint32_t k = shares_of_triangles.starts[c]; k < shares_of_triangles.starts[c + 1]; ++k) {
            if (patches.back().triangles.count == ContactPatch::most_triangles) begin_patch();
            triangle_slots.add(patches.back().triangles, triangles_[shares_of_triangles.order[k]]);
        }
        for (std::uint32_t k = shares_of_edges.starts[c]; k < shares_of_edges.starts[c + 1]; ++k) {
            if (patches.back().edges.count == ContactPatch::most_edges) begin_patch();
            edge_slots.add(patches.back().edges, edges_[shares_of_edges.order[k]]);
        }
    }
    vertex_slots_ = vertex_slots.finish();
    triangle_slots_ = triangle_slots.finish();
    edge_slots_ = edge_slots.finish();
    corner_slots_ = share_corners(patches, vertex_slots_, triangle_slots_, edge_slots_);
    patches_ = SharedBuffer<ContactPatch>(patches);
    flat_rest_ = FlatRest({rest_positions, triangles(), patches, corner_slots_, triangle_slots_});
}

void ContactMesh::find_corners() {
    corner_starts_ = SharedBuffer<std::uint32_t>(particles_ + std::size_t{1});
    corner_triangles_ = SharedBuffer<std::uint32_t>(3 * triangles_.size());
    for (const Triangle& t : triangles_)
        for (const std::uint32_t i : t) ++corner_starts_[i + 1];
    for (std::uint32_t i = 0; i < particles_; ++i) corner_starts_[i + 1] += corner_starts_[i];
    std::vector<std::uint32_t> next(corner_starts_.begin(), corner_starts_.end() - 1);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
        for (const std::uint32_t i : triangles_[t]) corner_triangles_[next[i]++] = t;
}

namespace {

template <std::uint32_t corner_count>
bool are_sound(const FeatureSlots<corner_count>& slots, std::uint32_t particles) {
    return std::ranges::all_of(slots.corners, [&](const SharedBuffer<std::uint32_t>& corner) {
        return corner.size() == slots.corners[0].size() && corner.size() % 16 == 0 &&
               are_below(corner.span(), particles);
    });
}

/// Whether a patch's slots are there, and are not more than a patch can have.
template <std::uint32_t corner_count>
bool has(const FeatureSlots<corner_count>& slots, const SlotSpan& span, std::uint32_t most) {
    return span.first % 16 == 0 && span.count <= most &&
           std::uint64_t{span.first} + span.count <= slots.corners[0].size();
}

}  // namespace

bool ContactMesh::is_sound(std::uint32_t particle_count) const {
    const auto has_slots = [&](const ContactPatch& patch) {
        return has(vertex_slots_, patch.vertices, ContactPatch::most_vertices) &&
               has(triangle_slots_, patch.triangles, ContactPatch::most_triangles) &&
               has(edge_slots_, patch.edges, ContactPatch::most_edges) &&
               has(corner_slots_, patch.corners, particle_count);
    };
    return particles_ == particle_count && std::isfinite(least_height_) && least_height_ >= 0 &&
           are_below(numbers_of<std::uint32_t>(triangles_), particle_count) &&
           are_below(numbers_of<std::uint32_t>(edges_), particle_count) &&
           corner_triangles_.size() == 3 * triangles_.size() &&
           are_offsets(corner_starts_.span(), particle_count, corner_triangles_.size()) &&
           are_below(corner_triangles_.span(), triangles_.size()) &&
           are_sound(vertex_slots_, particle_count) && are_sound(triangle_slots_, particle_count) &&
           are_sound(edge_slots_, particle_count) && are_sound(corner_slots_, particle_count) &&
           std::ranges::all_of(patches_, has_slots) &&
           flat_rest_.is_sound(patches_.size(), triangle_slots_.corners[0].size());
}

std::size_t ContactMesh::bytes() const noexcept {
    return triangles_.bytes() + edges_.bytes() + corner_starts_.bytes() + corner_triangles_.bytes() +
           patches_.bytes() + vertex_slots_.bytes() + triangle_slots_.bytes() + edge_slots_.bytes() +
           corner_slots_.bytes() + flat_rest_.bytes();
}

}  // namespace weft
