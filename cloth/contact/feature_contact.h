#pragma once
// Contact between features, through one substep of one cloth or of a group: what is near what, its rows in
// the equation, and at the end the motion that lets nothing through.

#include <algorithm>
#include <cstdint>
#include <span>

#include "cloth/equation/pair_rows.h"
#include "collision/contact/crossings/tangles.h"
#include "collision/contact/pairs/narrowing.h"
#include "collision/contact/pairs/pair_finder.h"
#include "collision/contact/response/settle.h"
#include "collision/impact_zones/impact_zones.h"
#include "collision/search/rest_filter.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// A cloth as a body in contact: what of it does not change from step to step.
struct ContactCloth {
    const ContactMesh* mesh = nullptr;
    RestFilter near_at_rest = {};  ///< particles that no force is to part
    float radius = 0;    ///< features of two bodies nearer than the mean of theirs are pushed apart [m]
    float floor = 0;     ///< features are never let nearer than the least of all bodies' [m]
    float friction = 0;  ///< Coulomb coefficient; two bodies have the geometric mean of theirs
    std::uint32_t layer = 1, mask = ~0u;
    bool by_zones = false;  ///< its collisions are resolved by impact zones, where nothing else is near
    float restitution = 0;  ///< of these
};

/// Predicted motion for detection: h v. Gravity is left out: it is common to everything that falls.
struct ExpectedMotion {
    std::span<const Vec4> velocities;
    float h = 0;  ///< [s]
};

/// What came of a substep.
struct FeatureCounts {
    std::uint32_t pairs = 0;       ///< of features, for which the equation has a row
    std::uint32_t truncated = 0;   ///< particles that went less far than was solved for
    TangleCounts tangles = {};     ///< what crossed at the start
    bool overflowed = false;       ///< there was no room for all pairs: nothing moved but in common
    std::uint64_t unresolved = 0;  ///< by zones: pairs that still collide; one more where the list was full
    bool crossed = false;          ///< see crosses_anew()
};

/// Whether each substep looks for what must never be: it takes as long as a search.
#ifdef NDEBUG
inline constexpr bool looks_for_new_crossings = false;
#else
inline constexpr bool looks_for_new_crossings = true;
#endif

/// Its particles are numbered through all bodies, each body from a multiple of 16 on. All its memory is
/// scratch: it is made anew in each part of a substep, and what it takes of a group is never more than what
/// the group's cloths would take each alone.
class FeatureContact {
  public:
    /// Pairs that there is room for, per particle and at least.
    static constexpr std::size_t pairs_per_particle = 16, least_pairs = 4096;
    [[nodiscard]] static std::size_t room_for_pairs(std::size_t particles) {
        return std::max(least_pairs, pairs_per_particle * particles);
    }

    /// How many numbers a body's particles take, since each body begins at a whole group.
    [[nodiscard]] static std::uint32_t particles_of(const ContactMesh& mesh) noexcept {
        constexpr std::uint32_t group = 16;  // whole groups of a system's rows
        return (mesh.particles() + group - 1) / group * group;
    }

    /// Lays a substep's arrays out, of these bodies, which must outlive it. `zones` resolves them if all are
    /// by zones; only then it may not be null, unless nothing but the size is asked for.
    void lay_out(Scratch& scratch, std::span<const ContactCloth> bodies, ImpactZones* zones);

    /// Places a body, with the way that it is expected to go.
    void place(Parallel& parallel, std::size_t body, std::span<const Vec4> positions,
               const ExpectedMotion& expected);
    /// Of a body that may cross something: what it remembers of what it crosses. Without it nothing is looked
    /// for that crosses.
    void recall(std::size_t body, std::span<const TangleMemory> memory);
    /// Finds what is near what. `is_crowd` says whether more is near than there is room for: before, as the
    /// last search found, which only spares one; after, as this one did.
    void detect(Parallel& parallel, bool& is_crowd);
    /// Whether what was there at the start may cross something at the end; then what bodies are to remember.
    [[nodiscard]] bool may_cross() const noexcept { return tangles_.any() || is_uncertain_; }
    [[nodiscard]] std::span<const TangleMemory> memory(std::size_t body);
    [[nodiscard]] std::uint32_t first(std::size_t body) const { return bodies_[body].first; }

    /// The bodies' bases in the equation; then the rows.
    void set_base(Parallel& parallel, std::size_t body, std::span<const Vec4> base_positions);
    /// Of one that is where it will be.
    void set_fixed_base(Parallel& parallel, std::size_t body, std::span<const Vec4> positions);
    void make_rows(Parallel& parallel, float gamma);
    [[nodiscard]] PairRows& rows() noexcept { return rows_; }

    /// The end of a part of a substep, in this order: takes over where the bodies have come to; pushes apart
    /// what is still too near; shortens the way of particles that would leave a box, in which they start;
    /// cuts the motion so that nothing passes through; hands the places back, with the velocities that
    /// follow. `is_pushed`: colliders touched some of it.
    void arrive(Parallel& parallel, std::size_t body, std::span<const Vec4> positions);
    void project(Parallel& parallel);
    /// Whether some of a body is outside of a box at the end.
    [[nodiscard]] bool leaves(Parallel& parallel, std::size_t body, const Bounds& box);
    void keep_within(Parallel& parallel, std::size_t body, const Bounds& box);
    FeatureCounts cut(Parallel& parallel, bool is_pushed);
    /// The same again, from the motion that was cut last: what is cut stands still, and goes with no common
    /// motion.
    FeatureCounts cut_without_common(Parallel& parallel, bool is_pushed);
    /// Starts from where the last cut ended, for what it took of the motion: a cut lets each pair move along
    /// one plane, that of its start, and what turns meanwhile stops before it would have to. Counts what is
    /// still missing.
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
    /// After that, whether anything crosses, where nothing did at the start.
    [[nodiscard]] bool crosses_anew(Parallel& parallel);
    void hand_back(Parallel& parallel, std::size_t body, float h, std::span<Vec4> positions,
                   std::span<Vec4> velocities) const;

    /// Whether all bodies are resolved by impact zones: then they are placed, arrive and are cut, and nothing
    /// else but kept within boxes.
    [[nodiscard]] bool uses_zones() const noexcept { return uses_zones_; }

  private:
    void remember_nothing();
    void find_near(Parallel& parallel, bool& is_crowd);
    void make_laws(Parallel& parallel);
    void leave_borders_to_faces();
    void find_tangles(Parallel& parallel);
    bool part_touching(Parallel& parallel);
    [[nodiscard]] std::span<const std::uint8_t> find_exempt(Parallel& parallel);
    [[nodiscard]] bool are_near_at_rest(const FeaturePair& pair, std::uint32_t corners_of_a) const;
    /// How far a search looks.
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
    /// From the motion that was searched for to the one that is to be cut.
    struct Change {
        float longest = 0;           ///< of the motions that are to be cut [m]; infinite if one is not finite
        std::uint32_t unlisted = 0;  ///< particles that PairFinder::is_unlisted
        std::uint32_t marked = 0;    ///< particles with any mark
    };
    [[nodiscard]] Change change_of_motion(Parallel& parallel, float reach);
    [[nodiscard]] BodyGroup group() const { return {ranges_.span(), start_.span()}; }

    /// Share of the radius that features have which are nearest at a border: mostly others beside them are
    /// nearer, and have the force. They are three in four.
    static constexpr float of_borders = 0.5f;
    /// What the solver leaves of overlap is projected to this part of the radius before motion is cut.
    static constexpr float projected_gap = 0.5f;
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
    FeatureCounts near_;         // what of it was detected
    bool has_all_near_ = false;  // pairs_ has all within the radius, over the motions in searched_
    PairRows rows_;
    Settler settler_;
    CrossingList crossings_;
    Tangles tangles_;
    ScratchArray<TangleMemory> memory_;  // only if may_cross_; all 0 where no body has recalled its own
    ScratchArray<std::uint8_t> exempt_;  // by pair
    bool may_cross_ = false;
    bool is_uncertain_ = false;  // rounding may have made features cross
    bool is_pinned_ = false;     // some particle is
    float h_ = 0;
    ScratchArray<PairLaw> laws_;
    ScratchArray<float> wanted_;
    ScratchArray<std::uint32_t> nearest_faces_;  // of vertices: the pair with the triangle that they are over
    ScratchArray<Vec4> start_, displacements_, base_;
    ScratchArray<Vec4> searched_;   // motions of the first search; from the cut on, displacements before it
    ScratchArray<float> partials_;  // by block
    ScratchArray<Change> changes_;  // by block
    ScratchArray<std::uint8_t> marks_;       // by particle: see PairFinder::find_more()
    ScratchArray<std::uint32_t> colliding_;  // room for as many as pairs_; only by zones
};

}  // namespace weft
