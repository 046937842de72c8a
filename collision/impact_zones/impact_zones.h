#pragma once
// Collisions of cloth with cloth within a step, resolved zone by zone with momentum kept (S. Huh, D. Metaxas,
// N. Badler, "Collision resolutions in cloth simulation", 2001, section 3).

#include <cstdint>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "collision/impact_zones/collision_clusters.h"
#include "collision/impact_zones/linear_program.h"

namespace weft {

/// Writes the pairs that a motion brings nearer than `gap` along their normals to `colliding`, ascending, and
/// returns their number. Pairs that approach by no more than `still` are left out: between bundles that lie
/// still, rounding would decide. Precondition: there is room for all.
std::uint32_t find_colliding(const PairList& pairs, std::span<const Vec4> positions,
                             std::span<const Vec4> motions, float gap, float still,
                             std::span<std::uint32_t> colliding);

struct ZoneSettings {
    /// C_e by body: relative velocity of two clusters after their collision over that before it, 0 to 1; two
    /// bodies have the greater. Empty: 0.
    std::span<const float> restitutions = {};
    /// Whether every particle of a cluster gets the cluster's velocity, as in the source. If not, it gets the
    /// cluster's change of velocity: cloth may go on bending and colliding within the cluster.
    bool as_bundles = true;
    /// Clusters that separate more slowly than this still collide, as their pairs say: the round before has
    /// stopped them up to rounding, which must not decide whether they become bundles.
    double still = 0;
};

struct ZoneCounts {
    std::uint32_t zones = 0;       ///< zones of clusters that approach each other
    std::uint32_t clusters = 0;    ///< clusters before any were merged
    std::uint32_t merged = 0;      ///< clusters merged into others
    std::uint32_t collisions = 0;  ///< pairs of clusters that collide
    std::uint32_t programs = 0;    ///< zones solved by linear programming
    std::uint32_t relaxed = 0;     ///< zones too large for that, or too many
    std::uint32_t unresolved = 0;  ///< pairs of which a side is in no cluster, or both are in one
};

/// In the source's words, connected colliding particles of one surface are a collision cluster, and clusters
/// that collide an impact zone. Choices that it leaves open:
///   - Any cluster that collides with itself is split, not only one that is alone in its zone.
///   - Clusters that collide with each other are never merged.
///   - A cluster's velocity is the mean by mass, so that its momentum is what eq. 2 has.
///   - Eqs. 1 and 2 do not determine N velocities in space: momentum is exchanged along the directions of
///     collision. Pairs of clusters that separate already have no equation.
///   - A zone in which eqs. 1 would need an impulse that pulls counts as cyclic.
/// It runs on one thread, on colliding particles alone; nothing is allocated after reserve(). Its time grows
/// with the colliding pairs, which are sorted, however they form zones.
class ImpactZones {
  public:
    /// Zones of more collisions are relaxed instead of solved: Gauss-Seidel on eq. 3, momentum kept.
    static constexpr std::size_t most_solved = 32;
    /// After this number of linear programmes, zones that would need one are relaxed, too.
    static constexpr std::uint32_t most_programs = 32;
    /// Clusters are merged only if one of them collides with no more others than this.
    static constexpr std::uint32_t most_compared = 64;

    void reserve(std::size_t particles, std::size_t pairs);
    /// Bytes that reserve() takes for each particle and for each pair, besides a constant.
    static const std::size_t bytes_per_particle, bytes_per_pair;

    /// Changes the velocities, or in the same way displacements, of free particles in zones. The momentum of
    /// clusters that nothing holds is kept to rounding.
    ZoneCounts resolve(const CollidingPairs& collisions, const ZoneSettings& settings,
                       std::span<Vec4> velocities);

    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// Two clusters that collide.
    struct Collision {
        std::uint32_t a, b;
        Eigen::Vector3d direction;  // from b to a
        double wanted = 0;          // least (v_a - v_b) . direction after the collision
        double impulse = 0;
        std::uint32_t zone = 0;
    };

    void list_collisions(const CollidingPairs& collisions, ZoneCounts& counts);
    void join_equal();
    void merge_close(const CollidingPairs& collisions, ZoneCounts& counts);
    void list_ends();
    [[nodiscard]] bool may_merge(std::uint32_t a, std::uint32_t b);
    void merge(std::uint32_t a, std::uint32_t b);
    void aim(const ZoneSettings& settings);
    void solve(std::span<Collision> zone, ZoneCounts& counts);
    [[nodiscard]] bool solve_equations(std::span<Collision> zone);
    [[nodiscard]] bool solve_program(std::span<Collision> zone);
    void relax(std::span<Collision> zone);
    void assemble(std::span<const Collision> zone);
    void apply(const CollidingPairs& collisions, const ZoneSettings& settings, std::span<Vec4> velocities);
    std::uint32_t root(std::uint32_t cluster);
    std::uint32_t zone_root(std::uint32_t cluster);
    [[nodiscard]] double inverse_mass(std::uint32_t cluster) const;

    CollisionClusters clusters_;
    std::vector<CollisionCluster> merged_;           // by cluster: the merged one, at its root
    std::vector<std::uint32_t> roots_, zone_roots_;  // by cluster
    // A ring of the ends of each cluster's collisions: ends_ has one end, next_ends_ the one after each. The
    // k-th collision has the ends 2 k and 2 k + 1.
    std::vector<std::uint32_t> ends_, next_ends_;
    std::vector<std::uint32_t> degrees_;   // by cluster: number of ends
    std::vector<std::uint8_t> seen_;       // by cluster: marks and small counts
    std::vector<Eigen::Vector3d> starts_;  // by cluster: velocities before the collisions
    std::vector<Collision> collisions_;
    std::vector<double> matrix_, wanted_, cost_, impulses_;  // of a zone
    LinearProgram program_;
};

}  // namespace weft
