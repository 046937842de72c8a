#pragma once
// Multigrid on any mesh (Brandt 1977; Galerkin operators on aggregated nodes after Vanek, Mandel, Brezina
// 1996): one symmetric V-cycle as a preconditioner for an implicit system. Levels are made once; their
// operators at each build().

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

    /// Takes over saved levels that fit the system. No particle is pinned; there is no memory of its own.
    Multigrid(const ImplicitSystem& system, SavedLevels&& saved, std::uint32_t particles);
    /// The constant part of these levels, shared with them.
    [[nodiscard]] SavedLevels constant_part() const;

    /// A copy of the levels for a system of the same springs. Constant parts are shared.
    Multigrid(const Multigrid& other, const ImplicitSystem& system) : Multigrid(other) { system_ = &system; }

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
    void lay_out(Scratch& scratch, std::size_t pairs);
    /// lay_out() in memory of its own. Levels that were made have such memory; copies do not.
    void lay_out_alone(std::size_t pairs = 0) { own_scratch_.lay_out(*this, pairs); }

    /// Lists the pairs that push the cloth, and its stitches, for build(). Both number its particles from
    /// `first` on. Null: no pairs. Only one cloth at a time may call this for the same pairs.
    void list_pairs(PairRows* pairs, std::span<SeamRows* const> seams, std::uint32_t first);
    /// Sums the coarse operators of the system's present W, and of the pairs that are listed.
    void build(Parallel& parallel, ImplicitSystem& system);
    /// z = an approximation of W^-1 r, linear, symmetric and positive definite in r.
    void cycle(Parallel& parallel, ImplicitSystem& system, std::span<const Vec4> r, std::span<Vec4> z);

    [[nodiscard]] std::size_t levels() const noexcept { return coarse_.size(); }
    [[nodiscard]] const CoarseLevel& level(std::size_t k) const { return coarse_[k]; }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    Multigrid(const Multigrid&) = default;

    /// A spring with a pinned end.
    struct HeldSpring {
        std::uint32_t pinned, neighbour;
        std::uint32_t spring;  // its place in springs_, or constant
        float weight;          // of a constant spring, see ImplicitSystem::constant_block
    };
    static constexpr std::uint32_t constant = ~0u;
    /// Links whose blocks are constant.
    struct ConstantLinks {
        SharedBuffer<Link> links;  // ascending
        SharedBuffer<float> weights;
    };
    using HeldSprings = HookedVector<HeldSpring>;

    /// `links`: those of the finest level; numbers[k]: the k-th link's number among constant ones, or none.
    void make_levels(SpringGraph graph, std::vector<Link> links, std::span<const std::uint32_t> numbers);
    static constexpr std::uint32_t none = ~0u;
    void sum_constant(std::uint32_t coarse_link) noexcept;
    /// Sums the constants again that a particle's links are in.
    void sum_constants_at(std::uint32_t particle) noexcept;
    /// The place of a link of the finest level in springs_.
    [[nodiscard]] std::uint32_t spring_of(const Link& link) const;
    /// body(neighbour, link) for the links of a particle, neighbours ascending.
    template <class Body>
    void for_each_link_of(std::uint32_t particle, const Body& body) const;
    [[nodiscard]] std::size_t links_of_particle(std::uint32_t particle) const;
    /// Writes the particle's springs from `at` on.
    void hold_springs_of(std::uint32_t particle, HeldSprings::iterator at) const;
    void mark(std::uint32_t particle, bool pinned) noexcept;
    /// Whether the pinned particles are those of inverse mass 0.
    [[nodiscard]] bool are_pinned(std::span<const Vec4> positions) const;
    void gather_pairs(Parallel& parallel);
    void hold_other_bodies();
    void sum_first_ground(Parallel& parallel, const ImplicitSystem& system);
    void solve_level(Parallel& parallel, std::size_t level);
    void relax_and_correct(Parallel& parallel, std::size_t level);

    const ImplicitSystem* system_;
    SharedBuffer<std::uint32_t> slots_;  // the system's slots with links at their first ends, ascending
    ScratchArray<Vec4> springs_;         // blocks of these slots, see ImplicitSystem::spring_blocks
    ConstantLinks constants_;
    HeldSprings held_;                    // ascending by pinned particle, then by neighbour
    AlignedBuffer<std::uint8_t> pinned_;  // 1 or 0
    AlignedBuffer<float> weights_;        // of the first level's P, rows of pinned particles 0
    std::vector<CoarseLevel> coarse_;
    ScratchArray<Vec4> smooth_, remainder_;
    OwnScratch own_scratch_;
    bool has_pairs_ = false;     // room for pairs was laid out
    std::uint32_t first_ = 0;    // the cloth's first particle in the listed pairs
    bool has_pins_set_ = false;  // the state of pins is known
    // The most links of one particle, and the links of all; 0: not counted yet.
    std::uint32_t most_links_ = 0;
    std::size_t all_links_ = 0;
};

}  // namespace weft
