#pragma once
// Collision clusters: particles that are in collision, joined along a surface (S. Huh, D. Metaxas, N. Badler,
// "Collision resolutions in cloth simulation", 2001).

#include <cmath>
#include <cstdint>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "collision/contact/pairs/pair_finder.h"
#include "collision/contact/pairs/pairs.h"
#include "weft/types.h"

namespace weft {

/// The dot product in this order on every machine; Eigen's order is that of the machine's vectors.
[[nodiscard]] inline double dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}
[[nodiscard]] inline double length_of(const Eigen::Vector3d& a) {
    return std::sqrt(dot(a, a));
}

/// Pairs that collide. Indices and positions are of all bodies' particles; positions.w is the inverse mass.
struct CollidingPairs {
    std::span<const ContactBody> bodies;
    std::span<const Vec4> positions;
    const PairList& pairs;
    std::span<const std::uint32_t> colliding;  ///< indices of the pairs that collide

    [[nodiscard]] std::span<const std::uint32_t> side_a(std::uint32_t pair) const {
        return std::span(pairs.pairs[pair].corners).first(pairs.corners_of_a(pair));
    }
    [[nodiscard]] std::span<const std::uint32_t> side_b(std::uint32_t pair) const {
        return std::span(pairs.pairs[pair].corners).subspan(pairs.corners_of_a(pair));
    }
};

/// A cluster of particles that moves as one mass.
struct CollisionCluster {
    std::size_t body = 0;
    std::size_t first = 0;                               ///< index in CollisionClusters::particles()
    double mass = 0;                                     ///< of its free particles [kg]; 0: all are held
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< of its centre of mass; the mean if all are held
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< sum of its faces' unit normals
};

class CollisionClusters {
  public:
    static constexpr std::uint32_t none = ~0u;

    void reserve(std::size_t particles);
    static constexpr std::size_t bytes_per_particle =
        sizeof(CollisionCluster) + 3 * sizeof(std::uint32_t) + 2;

    /// Finds the clusters of the pairs' corners. A cluster that collides with itself is split (section 3.1)
    /// at its border edges, whose faces' normals have N1 . N2 < 0; their particles are then in none. If a
    /// cluster still collides with itself, being bent gradually, it is split by the side of one of its
    /// normals on which its particles' normals are.
    void find(const CollidingPairs& collisions, std::span<const Vec4> velocities);

    [[nodiscard]] std::span<const CollisionCluster> all() const noexcept { return clusters_; }
    /// The particles of one cluster after the other, in an order that does not depend on threads.
    [[nodiscard]] std::span<const std::uint32_t> particles() const noexcept { return members_; }
    [[nodiscard]] std::span<const std::uint32_t> particles_of(std::size_t cluster) const noexcept {
        const std::size_t next = cluster + 1, first = clusters_[cluster].first;
        const std::size_t end = next < clusters_.size() ? clusters_[next].first : members_.size();
        return particles().subspan(first, end - first);
    }
    [[nodiscard]] std::uint32_t of(std::uint32_t particle) const noexcept { return of_[particle]; }
    /// The cluster of the first corner that is in any.
    [[nodiscard]] std::uint32_t of(std::span<const std::uint32_t> corners) const noexcept;

    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    enum class Part : std::uint8_t { outside, marked, other_side, border };

    [[nodiscard]] bool find_split(const CollidingPairs& collisions);
    void mark(const CollidingPairs& collisions);
    void label(std::span<const ContactBody> bodies);
    void cut_at_borders(const CollidingPairs& collisions);
    void cut_by_sides(const CollidingPairs& collisions);
    void measure(const CollidingPairs& collisions, std::span<const Vec4> velocities);

    std::vector<Part> parts_;        // by particle
    std::vector<std::uint32_t> of_;  // by particle
    std::vector<std::uint32_t> marked_, members_;
    std::vector<CollisionCluster> clusters_;
    std::vector<std::uint8_t> is_split_;  // by cluster: whether it collides with itself
};

/// Calls visit(particle), numbered through all bodies, for those that an edge joins to this one; some twice.
template <class Visit>
void for_each_neighbour(const ContactBody& body, std::uint32_t particle, const Visit& visit) {
    for (const std::uint32_t t : body.mesh->triangles_of(particle - body.first))
        for (const std::uint32_t corner : body.mesh->triangles()[t])
            if (body.first + corner != particle) visit(body.first + corner);
}

}  // namespace weft
