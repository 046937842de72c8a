#include "collision/impact_zones/collision_clusters.h"

#include <algorithm>
#include <Eigen/Geometry>

#include "collision/contact/crossings/contours.h"
#include "engine/vector.h"

namespace weft {

namespace {

using Eigen::Vector3d;

Vector3d unit_normal(const ContactBody& body, std::uint32_t triangle, std::span<const Vec4> positions) {
    const ContactMesh::Triangle& corners = body.mesh->triangles()[triangle];
    const auto at = [&](std::size_t k) -> Vector3d {
        return xyz(positions[body.first + corners[k]]).cast<double>();
    };
    const Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0));
    const double length = length_of(normal);
    return length > 0 ? Vector3d(normal / length) : Vector3d::Zero();
}

Vector3d sum_of_normals(const ContactBody& body, std::uint32_t particle, std::span<const Vec4> positions) {
    Vector3d sum = Vector3d::Zero();
    for (const std::uint32_t t : body.mesh->triangles_of(particle - body.first))
        sum += unit_normal(body, t, positions);
    return sum;
}

/// A border edge is one with a significant bend: N1 . N2 < 0 (Huh, Metaxas, Badler 2001, section 3.1).
bool is_border_edge(const ContactBody& body, std::uint32_t i, std::uint32_t j,
                    std::span<const Vec4> positions) {
    Vector3d first = Vector3d::Zero();
    bool has_first = false, is_bent = false;
    for_each_beside(body, {i, j}, [&](std::uint32_t t, std::uint32_t) {
        const Vector3d normal = unit_normal(body, t, positions);
        if (has_first) is_bent = is_bent || dot(first, normal) < 0;
        if (!has_first) first = normal;
        has_first = true;
    });
    return is_bent;
}

}  // namespace

void CollisionClusters::reserve(std::size_t particles) {
    parts_.assign(particles, Part::outside);
    of_.assign(particles, none);
    marked_.reserve(particles);
    members_.reserve(particles);
    clusters_.reserve(particles);
    is_split_.reserve(particles);
}

std::uint32_t CollisionClusters::of(std::span<const std::uint32_t> corners) const noexcept {
    for (const std::uint32_t corner : corners)
        if (of_[corner] != none) return of_[corner];
    return none;
}

void CollisionClusters::mark(const CollidingPairs& collisions) {
    for (const std::uint32_t i : marked_) {
        parts_[i] = Part::outside;
        of_[i] = none;
    }
    marked_.clear();
    for (const std::uint32_t pair : collisions.colliding) {
        for (const std::uint32_t corner : collisions.pairs.pairs[pair].corners) {
            if (parts_[corner] == Part::marked) continue;
            parts_[corner] = Part::marked;
            marked_.push_back(corner);
        }
    }
}

/// Makes clusters of marked particles: those of one part that edges join.
void CollisionClusters::label(std::span<const ContactBody> bodies) {
    for (const std::uint32_t i : marked_) of_[i] = none;
    members_.clear();
    clusters_.clear();
    for (const std::uint32_t seed : marked_) {
        if (of_[seed] != none || parts_[seed] == Part::border) continue;
        const auto cluster = static_cast<std::uint32_t>(clusters_.size());
        const std::size_t body = body_of(bodies, seed);
        clusters_.push_back({.body = body, .first = members_.size()});
        of_[seed] = cluster;
        std::size_t next = members_.size();
        for (members_.push_back(seed); next < members_.size(); ++next) {
            for_each_neighbour(bodies[body], members_[next], [&](std::uint32_t i) {
                if (of_[i] != none || parts_[i] != parts_[seed]) return;
                of_[i] = cluster;
                members_.push_back(i);
            });
        }
    }
}

bool CollisionClusters::find_split(const CollidingPairs& collisions) {
    is_split_.assign(clusters_.size(), 0);
    bool any = false;
    for (const std::uint32_t pair : collisions.colliding) {
        const std::uint32_t a = of(collisions.side_a(pair));
        if (a == none || a != of(collisions.side_b(pair))) continue;
        is_split_[a] = 1;
        any = true;
    }
    return any;
}

void CollisionClusters::cut_at_borders(const CollidingPairs& collisions) {
    for (const std::uint32_t i : members_) {
        const std::uint32_t cluster = of_[i];
        if (is_split_[cluster] == 0) continue;
        const ContactBody& body = collisions.bodies[clusters_[cluster].body];
        for_each_neighbour(body, i, [&](std::uint32_t j) {
            if (of_[j] == cluster && i < j && is_border_edge(body, i, j, collisions.positions))
                parts_[i] = parts_[j] = Part::border;
        });
    }
}

void CollisionClusters::cut_by_sides(const CollidingPairs& collisions) {
    for (const std::uint32_t pair : collisions.colliding) {
        const std::uint32_t cluster = of(collisions.side_a(pair));
        if (cluster == none || is_split_[cluster] == 0 || cluster != of(collisions.side_b(pair))) continue;
        is_split_[cluster] = 0;
        const ContactBody& body = collisions.bodies[clusters_[cluster].body];
        const Vector3d side = sum_of_normals(body, collisions.side_b(pair).front(), collisions.positions);
        for (const std::uint32_t i : particles_of(cluster))
            if (dot(side, sum_of_normals(body, i, collisions.positions)) < 0) parts_[i] = Part::other_side;
    }
}

// A cluster's normal is that of its faces or, if none is wholly in it, of the faces around its particles.
void CollisionClusters::measure(const CollidingPairs& collisions, std::span<const Vec4> velocities) {
    for (std::uint32_t c = 0; c < clusters_.size(); ++c) {
        CollisionCluster& cluster = clusters_[c];
        const ContactBody& body = collisions.bodies[cluster.body];
        Vector3d momentum = Vector3d::Zero(), sum = Vector3d::Zero(), around = Vector3d::Zero();
        const std::span<const std::uint32_t> particles = particles_of(c);
        for (const std::uint32_t i : particles) {
            const Vector3d velocity = xyz(velocities[i]).cast<double>();
            const double inverse_mass = static_cast<double>(collisions.positions[i].w);
            sum += velocity;
            if (inverse_mass > 0) {
                cluster.mass += 1 / inverse_mass;
                momentum += velocity / inverse_mass;
            }
            for (const std::uint32_t t : body.mesh->triangles_of(i - body.first)) {
                const ContactMesh::Triangle& corners = body.mesh->triangles()[t];
                const Vector3d normal = unit_normal(body, t, collisions.positions);
                around += normal;
                const bool is_first = body.first + std::ranges::min(corners) == i;
                const auto is_in = [&](std::uint32_t corner) { return of_[body.first + corner] == c; };
                if (is_first && std::ranges::all_of(corners, is_in)) cluster.normal += normal;
            }
        }
        if (cluster.normal.isZero(0)) cluster.normal = around;
        cluster.velocity = cluster.mass > 0 ? Vector3d(momentum / cluster.mass)
                                            : Vector3d(sum / static_cast<double>(particles.size()));
    }
}

void CollisionClusters::find(const CollidingPairs& collisions, std::span<const Vec4> velocities) {
    mark(collisions);
    label(collisions.bodies);
    if (find_split(collisions)) {
        cut_at_borders(collisions);
        label(collisions.bodies);
        if (find_split(collisions)) {
            cut_by_sides(collisions);
            label(collisions.bodies);
        }
    }
    measure(collisions, velocities);
}

std::size_t CollisionClusters::bytes() const noexcept {
    return parts_.capacity() * sizeof(Part) +
           (of_.capacity() + marked_.capacity() + members_.capacity()) * sizeof(std::uint32_t) +
           clusters_.capacity() * sizeof(CollisionCluster) + is_split_.capacity();
}

}  // namespace weft
