#pragma once
// Contact between features through one substep of a cloth or a group: detection of near pairs, their rows in
// the equation, and at the end the cut of the motion, so that nothing crosses anew.

#include <algorithm>
#include <cstdint>
#include <span>

#include "cloth/equation/pairs/pair_rows.h"
#include "collision/contact/crossings/tangles.h"
#include "collision/contact/pairs/narrowing.h"
#include "collision/contact/pairs/pair_finder.h"
#include "collision/contact/response/settle.h"
#include "collision/impact_zones/impact_zones.h"
#include "collision/search/rest_filter.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// A cloth as a body in contact: the data that is constant from step to step.
struct ContactCloth {
    const ContactMesh* mesh = nullptr;
    RestFilter near_at_rest = {};  ///< particles near each other at rest, which repel at shorter range
    float radius = 0;    ///< contact radius; features of two bodies nearer than the mean of both repel [m]
    float floor = 0;     ///< least gap; the least of all bodies' bounds every pair's gap [m]
    float friction = 0;  ///< Coulomb coefficient; two bodies have the geometric mean of theirs
    std::uint32_t layer = 1, mask = ~0u;
    bool by_zones = false;  ///< impact zones resolve its collisions, if all bodies of the group have this
    float restitution = 0;  ///< of collisions in impact zones
};

/// Predicted motion for detection: h v. Gravity is left out: it is common to everything that falls.
struct ExpectedMotion {
    std::span<const Vec4> velocities;
    float h = 0;  ///< [s]
};

/// Statistics of a substep.
struct FeatureCounts {
    std::uint32_t pairs = 0;       ///< detected pairs of features; with zones, pairs that collide
    std::uint32_t truncated = 0;   ///< particles whose motion was cut
    TangleCounts tangles = {};     ///< crossings at the start
    bool overflowed = false;       ///< a pair list was full; in the cut at most the common motion remains
    std::uint64_t unresolved = 0;  ///< pairs that zones leave colliding; one more where the list was full
    bool crossed = false;          ///< see crosses_anew()
};

/// Whether each substep checks that nothing crosses anew; the check takes as long as a search.
#ifdef NDEBUG
inline constexpr bool looks_for_new_crossings = false;
#else
inline constexpr bool looks_for_new_crossings = true;
#endif

/// Particles are numbered through all bodies, each body from a multiple of 16 on. All memory is scratch, laid
/// out anew in each part of a substep. A group takes no more of it than its cloths together would take alone.
class FeatureContact {
  public:
    /// Capacity of the pair list: per particle, and at least.
    static constexpr std::size_t pairs_per_particle = 16, least_pairs = 4096;
    [[nodiscard]] static std::size_t room_for_pairs(std::size_t particles) {
        return std::max(least_pairs, pairs_per_particle * particles);
    }
    /// The pairs of a full list that may have rows in the equation: faces stand for most pairs of edges.
    static constexpr std::size_t rows_per_particle = 8;
    [[nodiscard]] static std::size_t room_for_rows(std::size_t particles) {
        return std::max(least_pairs, rows_per_particle * particles);
    }

    /// Particle numbers that a body takes: its particles, padded to whole groups.
    [[nodiscard]] static std::uint32_t particles_of(const ContactMesh& mesh) noexcept {
        constexpr std::uint32_t group = 16;  // whole groups of a system's rows
        return (mesh.particles() + group - 1) / group * group;
    }

    /// Lays out a substep's arrays for these bodies, which must outlive it. `zones` resolves collisions if
    /// all bodies are by zones; it may be null otherwise, and while the layout is only measured.
    void lay_out(Scratch& scratch, std::span<const ContactCloth> bodies, ImpactZones* zones);

    /// Sets a body's positions at the start, and the motion that is expected of it.
    void place(Parallel& parallel, std::size_t body, std::span<const Vec4> positions,
               const ExpectedMotion& expected);
    /// Hands in the tangle memory of a body that may cross something. Crossings are searched for only then,
    /// or after detect() has moved touching surfaces apart.
    void recall(std::size_t body, std::span<const TangleMemory> memory);
    /// Finds the pairs within the contact radius. `is_crowd`: more pairs are near than there is room for. In:
    /// as the last search found, which only saves a search; out: as this one found.
    void detect(Parallel& parallel, bool& is_crowd);
    /// Whether features may cross at the end, after crossings at the start or by rounding. If so, memory() is
    /// the tangle memory that bodies keep.
    [[nodiscard]] bool may_cross() const noexcept { return tangles_.any() || is_uncertain_; }
    [[nodiscard]] std::span<const TangleMemory> memory(std::size_t body);
    [[nodiscard]] std::uint32_t first(std::size_t body) const { return bodies_[body].first; }
    /// Number of particles of all bodies, with padding.
    [[nodiscard]] std::uint32_t particles() const noexcept {
        return static_cast<std::uint32_t>(start_.size());
    }

    /// Sets a body's base positions in the equation; make_rows() comes after all bodies' bases.
    void set_base(Parallel& parallel, std::size_t body, std::span<const Vec4> base_positions);
    /// Sets the base of a body that is not in the equation: its particles get inverse mass 0.
    void set_fixed_base(Parallel& parallel, std::size_t body, std::span<const Vec4> positions);
    void make_rows(Parallel& parallel, float gamma);
    [[nodiscard]] PairRows& rows() noexcept { return rows_; }

    /// The end of a part of a substep, in this order: arrive() takes the solved positions; project() pushes
    /// apart pairs that are still too near; keep_within() shortens motions that would leave a box, in which
    /// they start; cut() cuts the motion so that nothing crosses anew; hand_back() returns positions and the
    /// velocities that follow. `is_pushed`: colliders or worn limits touched some body.
    void arrive(Parallel& parallel, std::size_t body, std::span<const Vec4> positions);
    void project(Parallel& parallel);
    /// Whether any particle of a body ends outside a box.
    [[nodiscard]] bool leaves(Parallel& parallel, std::size_t body, const Bounds& box);
    void keep_within(Parallel& parallel, std::size_t body, const Bounds& box);
    FeatureCounts cut(Parallel& parallel, bool is_pushed);
    /// Repeats the last cut without a common motion: a particle that is cut goes a fraction of its own
    /// motion, and does not follow the group.
    FeatureCounts cut_without_common(Parallel& parallel, bool is_pushed);
    /// Cuts once more, from where the last cut ended, the motion that it took away. A cut separates each pair
    /// by one plane, that of its start, so pairs that turn stop earlier than they must. The counts are of the
    /// motion that is still missing.
    FeatureCounts go_on(Parallel& parallel, bool is_pushed);
    [[nodiscard]] bool had_common() const noexcept {
        return settler_.common().kind != CommonMotionKind::none;
    }
    /// Displacements of a body's particles [m]: before the last cut, after it.
    [[nodiscard]] std::span<const Vec4> uncut(std::size_t body) const {
        return searched_.span().subspan(ranges_[body].first, ranges_[body].count);
    }
    [[nodiscard]] std::span<const Vec4> displacements(std::size_t body) const {
        return displacements_.span().subspan(ranges_[body].first, ranges_[body].count);
    }
    [[nodiscard]] std::span<const Vec4> starts(std::size_t body) const {
        return start_.span().subspan(ranges_[body].first, ranges_[body].count);
    }
    /// After the cut: whether features cross, although none could at the start.
    [[nodiscard]] bool crosses_anew(Parallel& parallel);
    void hand_back(Parallel& parallel, std::size_t body, float h, std::span<Vec4> positions,
                   std::span<Vec4> velocities) const;

    /// Whether impact zones resolve all bodies. There is then no detect(), no project(), and there are no
    /// rows.
    [[nodiscard]] bool uses_zones() const noexcept { return uses_zones_; }

  private:
    void remember_nothing();
    void find_near(Parallel& parallel, bool& is_crowd);
    void make_laws(Parallel& parallel);
    void find_nearest_faces();
    void leave_to_faces(Parallel& parallel);
    void find_tangles(Parallel& parallel);
    bool part_touching(Parallel& parallel);
    /// Finds the crossings of features at these positions. Returns true if there are any.
    [[nodiscard]] bool any_crosses(Parallel& parallel, std::span<const Vec4> positions);
    [[nodiscard]] std::span<const std::uint8_t> find_exempt(Parallel& parallel);
    [[nodiscard]] bool are_near_at_rest(const FeaturePair& pair, std::uint32_t corners_of_a) const;
    /// Search radius: one of the lengths of each cloth, and a factor for pairs at borders.
    struct Reach {
        float ContactCloth::*of_cloth;
        float of_borders = 1;  ///< see PairFinder::find
    };
    void set_reach(float ContactCloth::*of_cloth);
    void find(Parallel& parallel, std::span<const Vec4> motions, const Reach& reach, FullList full);
    void find_of_motion(Parallel& parallel);
    void turn_normals(Parallel& parallel, std::span<const Vec4> motions);
    void find_for_cut(Parallel& parallel);
    void find_more(Parallel& parallel);
    [[nodiscard]] bool find_opened(Parallel& parallel);
    /// Shortens the motion until there is room for its pairs, and finds these.
    void find_for_part_of_way(Parallel& parallel);
    [[nodiscard]] SettleResult cut_listed(Parallel& parallel, bool is_pushed);
    [[nodiscard]] FeatureCounts counts_of(Parallel& parallel, const SettleResult& result);
    FeatureCounts stand_still();
    FeatureCounts settle_by_zones(Parallel& parallel);
    void find_for_zones(Parallel& parallel);
    [[nodiscard]] std::span<const std::uint32_t> find_colliding_pairs();
    void part_colliding(Parallel& parallel, std::span<const std::uint32_t> colliding);
    /// Difference between the motion that was searched for and the motion to be cut.
    struct Change {
        float longest = 0;           ///< of the motions that are to be cut [m]; infinite if one is not finite
        std::uint32_t unlisted = 0;  ///< particles with the mark PairFinder::is_unlisted
        std::uint32_t marked = 0;    ///< particles with any mark
    };
    [[nodiscard]] Change change_of_motion(Parallel& parallel, float reach);
    [[nodiscard]] BodyGroup group() const { return {ranges_.span(), start_.span()}; }

    /// Fraction of the radius for pairs whose closest points are at a border, three pairs in four. Features
    /// beside these are mostly nearer, and have the force.
    static constexpr float of_borders = 0.5f;
    /// Fraction of the radius for pairs that are near each other at rest. The radius would unfold them. With
    /// none, only the cut would know of them: a fold no wider than a triangle would try to pass through
    /// itself in every step, and stay.
    static constexpr float of_neighbours = 0.1f;
    /// Fraction of the radius to which pairs that the solver left too near are projected before the cut.
    static constexpr float projected_gap = 0.5f;
    /// The least gap to which any pair is projected, with force or without, in floors. The cut shortens the
    /// whole motion of a particle that would come nearer than the floor, so what stands at the floor could
    /// not slide, either.
    static constexpr float kept_floors = 2;
    static constexpr std::uint32_t projections = 4;

    void number_bodies();

    std::span<const ContactCloth> cloths_;
    bool uses_zones_ = false;
    ImpactZones* zones_ = nullptr;
    ScratchArray<ContactBody> bodies_;
    ScratchArray<ParticleRange> ranges_;
    ScratchArray<float> restitutions_;
    PairFinder finder_;
    PairNarrowing narrowing_;
    PairList pairs_;
    FeatureCounts near_;         // counts of detection
    bool has_all_near_ = false;  // pairs_ is complete within the radius, for the motions in searched_
    PairRows rows_;
    Settler settler_;
    CrossingList crossings_;
    Tangles tangles_;
    ScratchArray<TangleMemory> memory_;  // valid if may_cross_; 0 for bodies that recalled none
    ScratchArray<std::uint8_t> exempt_;  // by pair
    bool may_cross_ = false;
    bool is_uncertain_ = false;  // rounding may have made features cross
    bool is_pinned_ = false;     // some particle is pinned
    float h_ = 0;
    ScratchArray<PairLaw> laws_;
    ScratchArray<float> wanted_;
    /// A vertex's pairs with the triangles that it is over: the nearest, and the nearest on the other side.
    struct NearestFaces {
        static constexpr std::uint32_t none = ~0u;
        std::uint32_t nearest = none, behind = none;
    };
    ScratchArray<NearestFaces> nearest_faces_;  // by particle
    ScratchArray<Vec4> start_, displacements_, base_;
    ScratchArray<Vec4> searched_;   // motions of the first search; from the cut on, displacements before it
    ScratchArray<float> partials_;  // by block
    ScratchArray<Change> changes_;  // by block
    ScratchArray<std::uint8_t> marks_;       // by particle: see PairFinder::find_more()
    ScratchArray<std::uint32_t> colliding_;  // room for as many as pairs_; only by zones
};

}  // namespace weft
