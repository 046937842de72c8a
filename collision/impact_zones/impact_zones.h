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

/// Which pairs a motion brings nearer than `gap` along their normals: written to `colliding`, ascending, and
/// how many there are. Only those that approach by more than `still`: where bundles lie still, rounding would
/// decide. Precondition: there is room for all.
std::uint32_t find_colliding(const PairList& pairs, std::span<const Vec4> positions,
                             std::span<const Vec4> motions, float gap, float still,
                             std::span<std::uint32_t> colliding);

struct ZoneSettings {
    /// C_e by body: relative velocity of two clusters after their collision over that before it, 0 to 1; of
    /// two bodies the lesser. Empty: 0.
    std::span<const float> restitutions = {};
    /// Every particle of a cluster gets the cluster's velocity, as by the source. Else it gets the cluster's
    /// change: cloth goes on bending within it, and may go on colliding.
    bool as_bundles = true;
    /// Clusters that separate by less are taken for colliding, as their pairs say: a round before has stopped
    /// them to rounding, which is not to decide whether they become bundles.
    double still = 0;
};

struct ZoneCounts {
    std::uint32_t zones = 0;       ///< of clusters that approach each other
    std::uint32_t clusters = 0;    ///< before any were merged
    std::uint32_t merged = 0;      ///< into others
    std::uint32_t collisions = 0;  ///< of two clusters
    std::uint32_t programs = 0;    ///< zones solved by linear programming
    std::uint32_t relaxed = 0;     ///< zones too large for that, or too many
    std::uint32_t unresolved = 0;  ///< pairs of which a side is in no cluster, or both are in one
};

/// In the source's words: connected colliding particles of one surface are a collision cluster, clusters that
/// collide an impact zone. Where it leaves room, this is done:
///   - Any cluster that collides with itself is split, not only one that is alone in its zone.
///   - Clusters that collide with each other are never merged.
///   - A cluster's velocity is the mean by mass, so that its momentum is what eq. 2 has.
///   - What fills eqs. 1 and 2 up to N velocities in space: momentum is exchanged along the directions of
///     collision. Pairs of clusters that separate already have no equation.
///   - Where eqs. 1 would take an impulse that pulls, the zone counts as cyclic.
/// It runs on one thread, on colliding particles alone; nothing is allocated after reserve(). Time grows with
/// the colliding pairs, as they are sorted, whatever they make up.
class ImpactZones {
  public:
    /// Zones of more collisions are relaxed instead of solved: Gauss-Seidel on eq. 3, momentum kept.
    static constexpr std::size_t most_solved = 32;
    /// So are zones that would need a linear programme, after so many that had one.
    static constexpr std::uint32_t most_programs = 32;
    /// Clusters are merged if one of them collides with no more than so many others.
    static constexpr std::uint32_t most_compared = 64;

    void reserve(std::size_t particles, std::size_t pairs);
    /// Bytes that reserve() takes for each particle and for each pair, besides what it takes for none.
    static const std::size_t bytes_per_particle, bytes_per_pair;

    /// Changes velocities, or displacements just so, of free particles in zones. Momentum of what nothing
    /// holds is kept to rounding.
    ZoneCounts resolve(const CollidingPairs& collisions, const ZoneSettings& settings,
                       std::span<Vec4> velocities);

    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// Two clusters that collide.
    struct Collision {
        std::uint32_t a, b;
        Eigen::Vector3d direction;  // from b to a
        double wanted = 0;          // at least, of (v_a - v_b) . direction
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
    std::vector<CollisionCluster> merged_;           // by cluster: what it is one of, at its root
    std::vector<std::uint32_t> roots_, zone_roots_;  // by cluster
    // Of each cluster a ring of the collisions that it is in: an end of one, 2 k or 2 k + 1 of the k-th, and
    // the one after it.
    std::vector<std::uint32_t> ends_, next_ends_;
    std::vector<std::uint32_t> degrees_;   // by cluster: how many
    std::vector<std::uint8_t> seen_;       // likewise
    std::vector<Eigen::Vector3d> starts_;  // likewise: velocities before the collisions
    std::vector<Collision> collisions_;
    std::vector<double> matrix_, wanted_, cost_, impulses_;  // of a zone
    LinearProgram program_;
};

}  // namespace weft
