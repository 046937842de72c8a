#pragma once
// Multigrid on any mesh (Brandt 1977; Galerkin operators on aggregated nodes after Vanek, Mandel, Brezina
// 1996): one symmetric V-cycle as a preconditioner for an implicit system, or for those of cloths that seams
// join. Levels are made once; their operators at each build().

#include <algorithm>
#include <span>
#include <vector>

#include "cloth/equation/implicit_system.h"
#include "cloth/solver/levels/coarse_level.h"
#include "cloth/solver/levels/saved_levels.h"
#include "engine/memory/hooked_vector.h"

namespace weft {

class Multigrid {
  public:
    /// Makes the levels from the system's springs as they are linearised now; `positions` give their lengths,
    /// and the pins. The system is to outlive the levels.
    Multigrid(Parallel& parallel, ImplicitSystem& system, std::span<const Vec4> positions);

    /// A cloth that levels are made of.
    struct Source {
        ImplicitSystem& system;  ///< linearised
        std::span<const Vec4> positions;
    };
    /// Where the particles of each of these cloths begin in common levels, and last where they end.
    [[nodiscard]] static std::vector<std::uint32_t> first_particles(std::span<const Source> cloths);
    /// Common levels of cloths that stitches join, as links between particles by first_particles(). A stitch
    /// along a spring, or along another stitch, has no part in them. Until a cloth enters, it counts as held.
    Multigrid(Parallel& parallel, std::span<const Source> cloths, std::vector<Link> stitches);

    /// Takes over saved levels that fit the system. No particle is pinned; there is no memory of its own.
    Multigrid(ImplicitSystem& system, SavedLevels&& saved, std::uint32_t particles);
    /// The constant part of these levels, shared with them.
    [[nodiscard]] SavedLevels constant_part() const;

    /// A copy of the levels for a system of the same springs. Constant parts are shared.
    Multigrid(const Multigrid& other, ImplicitSystem& system) : Multigrid(other) {
        parts_.front().system = &system;
    }

    // Pinned particles have no part in coarse motions, and springs to them hold the coarse nodes. The state
    // of pins does not depend on the order of calls. A call that runs out of memory changes nothing.
    /// Does nothing if the particle is pinned.
    void pin(std::uint32_t particle);
    /// Allocates nothing. Does nothing if the particle is free.
    void unpin(std::uint32_t particle) noexcept;
    /// Pins the particles of inverse mass 0 and frees all others.
    void set_pins(std::span<const Vec4> positions);
    /// Reserves memory, so that up to `count` particles can be pinned at a time without allocation.
    void reserve_pins(std::size_t count);

    /// Lays out the operators and vectors of a substep. `pairs`: the most pairs in which the cloth touches
    /// itself.
    void lay_out(Scratch& scratch, std::size_t pairs) {
        lay_out(scratch, pairs, [] {});
    }
    /// The same, with arrays that `later` lays out where build() has its sums: they come into use after it.
    template <class Later>
    void lay_out(Scratch& scratch, std::size_t pairs, const Later& later) {
        lay_out_cycle(scratch, pairs);
        scratch.take_by_turns(
            [&] {
                for (CoarseLevel& level : coarse_) level.lay_out_sums(scratch);
            },
            later);
    }
    /// lay_out() in memory of its own. Levels that were made have such memory; copies do not.
    void lay_out_alone(std::size_t pairs = 0) { own_scratch_.lay_out(*this, pairs); }

    /// Begins an equation: none of the cloths is in it, until it enters.
    void leave() noexcept;
    /// Puts a cloth's system and equation in its place. The equation must outlive the cycles.
    void enter(std::uint32_t part, ImplicitSystem& system, const StepEquation& equation) noexcept;
    /// Whether this is the first of the cloths that have entered, which has the levels built, and so on.
    [[nodiscard]] bool is_led_by(std::uint32_t part) const noexcept { return leader_ == part; }
    /// Takes the pins of the cloths that have entered: those of common levels are known to no other call.
    void see_pins();
    /// Lists the pairs that push the cloths, for build(). Null: no pairs. Only one thread at a time may call
    /// this for the same pairs.
    void list_pairs(PairRows* pairs);
    /// Sums the coarse operators of the systems' present W, of stitches, and of the pairs that are listed.
    void build(Parallel& parallel);
    /// The vectors of a cloth in the next cycle: z = an approximation of W^-1 r, linear and positive definite
    /// in r; symmetric, too, without stitches.
    void set_vectors(std::uint32_t part, std::span<const Vec4> r, std::span<Vec4> z) noexcept {
        parts_[part].r = r;
        parts_[part].z = z;
    }
    void cycle(Parallel& parallel);
    /// set_vectors() and cycle() of levels of one cloth.
    void cycle(Parallel& parallel, std::span<const Vec4> r, std::span<Vec4> z) {
        set_vectors(0, r, z);
        cycle(parallel);
    }

    [[nodiscard]] std::size_t levels() const noexcept { return coarse_.size(); }
    [[nodiscard]] const CoarseLevel& level(std::size_t k) const { return coarse_[k]; }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    Multigrid(const Multigrid&) = default;

    /// A cloth of the levels.
    struct Part {
        ImplicitSystem* system;
        std::uint32_t first, count;              // particles
        std::uint32_t first_slot, slots;         // in slots_
        const StepEquation* equation = nullptr;  // null: it has not entered
        std::span<const Vec4> r{};
        std::span<Vec4> z{};
    };

    /// A spring with a pinned end.
    struct HeldSpring {
        std::uint32_t pinned, neighbour;
        std::uint32_t spring;  // its place in springs_, or constant
        float weight;          // of a constant spring, see ImplicitSystem::constant_block
    };
    static constexpr std::uint32_t constant = ~0u;
    /// Of relaxation on the finest level, where the spectrum of D^-1 W ends below 2.
    static constexpr float finest_step = 2 / (0.4f + 2.0f);
    using HeldSprings = HookedVector<HeldSpring>;

    [[nodiscard]] const Part& part_of(std::uint32_t particle) const {
        return *(std::ranges::upper_bound(parts_, particle, {}, &Part::first) - 1);
    }
    [[nodiscard]] std::span<const std::uint32_t> slots_of(const Part& part) const {
        return slots_.span().subspan(part.first_slot, part.slots);
    }
    /// The place of a stitch's block in springs_; none, if the link is no stitch.
    [[nodiscard]] std::uint32_t place_of_stitch(const Link& link) const;
    /// Writes the stitches' blocks. Those to cloth that is not in the equation go to the particles' ground.
    void sum_stitches();
    /// visit(seam, part) for each cloth's seams: those of two cloths twice.
    template <class Visit>
    void for_each_side(const Visit& visit) const;
    /// body(part, particle of the cloth, particle of the levels) at each end of a stitch, once.
    template <class Body>
    void for_each_end(const Body& body) const;
    /// of(part) += C x at the stitches' ends, after it is set to 0 there; x is in smooth_.
    template <class Of>
    void multiply_stitches(const Of& of);
    void subtract_stitches();
    void relax_stitches();

    /// `links`: those of the finest level; constants[k]: the k-th one's constant block, or 0.
    void make_levels(SpringGraph graph, std::vector<Link> links, std::span<const float> constants);
    static constexpr std::uint32_t none = ~0u;
    /// Adds `times` the constant blocks of a particle's links to free neighbours to the first level's.
    void add_constants_of(std::uint32_t particle, double times) noexcept;
    /// The place of a link of the finest level in springs_.
    [[nodiscard]] std::uint32_t spring_of(const Link& link) const;
    /// body(neighbour, link) for the links of a particle, neighbours ascending.
    template <class Body>
    void for_each_link_of(std::uint32_t particle, const Body& body) const;
    [[nodiscard]] std::size_t links_of_particle(std::uint32_t particle) const;
    /// Writes the particle's springs from `at` on.
    void hold_springs_of(std::uint32_t particle, HeldSprings::iterator at) const;
    /// Notes whether a particle is pinned. Precondition: it was not so before.
    void mark(std::uint32_t particle, bool pinned) noexcept;
    void gather_pairs(Parallel& parallel);
    void hold_other_bodies();
    /// Adds a multiple of K to the ground of a particle of the equation, if it is one of the levels'.
    void hold(std::uint32_t particle, float factor, const Symmetric3& stiffness);
    void sum_ground_of_particles(Parallel& parallel);
    void sum_first_ground(Parallel& parallel);
    /// Whether these are the levels of sewn cloth.
    [[nodiscard]] bool is_common() const noexcept { return !stitched_.empty(); }
    /// Whether any of the cloths has contact in its system.
    [[nodiscard]] bool has_contact_rows() const {
        return std::ranges::any_of(parts_, [](const Part& part) {
            return part.system != nullptr && part.system->contacts() != nullptr;
        });
    }
    /// Of the constant blocks, which levels of one cloth alone have.
    [[nodiscard]] float constant_scale() const {
        return is_common() ? 0 : parts_.front().system->constant_scale();
    }
    [[nodiscard]] Numbering numbering() const noexcept {
        return Numbering(std::span(ranges_).first(entered_));
    }
    [[nodiscard]] std::span<Vec4> of(const Part& part, ScratchArray<Vec4>& vector) const {
        return vector.span().subspan(part.first, part.count);
    }
    template <class IsPinned>
    void set_pins_where(const IsPinned& is_pinned);
    void lay_out_cycle(Scratch& scratch, std::size_t pairs);
    void solve_level(Parallel& parallel, std::size_t level);
    void relax_and_correct(Parallel& parallel, std::size_t level);

    std::vector<Part> parts_;
    std::vector<Numbering::Range> ranges_;    // of the parts that have entered, in the order of entry
    std::vector<Link> stitches_;              // of which the levels know, ascending
    std::vector<std::uint32_t> stitched_;     // the particles at ends of stitches, ascending
    std::uint32_t entered_ = 0, leader_ = 0;  // how many parts have entered; the first of them
    SharedBuffer<std::uint32_t>
        slots_;                   // the systems' slots with links at their first ends, each's ascending
    ScratchArray<Vec4> springs_;  // blocks of these, see ImplicitSystem::spring_blocks; last stitches'
    // The constant sums of the first level, by place, over links between free particles: see CoarseLinks.
    AlignedBuffer<double> constants_;
    SharedBuffer<float> shifts_;
    HeldSprings held_;                    // ascending by pinned particle, then by neighbour
    AlignedBuffer<std::uint8_t> pinned_;  // 1 or 0
    std::vector<CoarseLevel> coarse_;
    ScratchArray<Vec4> smooth_, remainder_;
    OwnScratch own_scratch_;
    bool has_pairs_ = false;  // room for pairs was laid out
    // The most links of one particle, and the links of all; 0: not counted yet.
    std::uint32_t most_links_ = 0;
    std::size_t all_links_ = 0;
};

}  // namespace weft
