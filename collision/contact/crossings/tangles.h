#pragma once
// Cloth that crosses cloth at the start of a step. What never lets anything cross would hold it so for ever:
// so it is told which pairs to let alone, and what crosses is pushed apart.

#include <cstdint>
#include <span>

#include "collision/contact/crossings/contours.h"
#include "collision/contact/crossings/side_vote.h"
#include "collision/contact/crossings/untangling.h"
#include "collision/contact/pairs/crossings.h"
#include "collision/contact/pairs/pairs.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// What a particle remembers of the contour that it was last near; all 0: of none.
struct TangleMemory {
    std::uint32_t name;   ///< of the contour: it keeps it from step to step
    std::uint32_t steps;  ///< without a contour until it is forgotten
    std::uint32_t least;  ///< crossings that the contour had at its shortest; see `votes`
    std::uint32_t votes;  ///< 1: it goes where votes say, and those of the minority count as crossings
    float stalled;        ///< for how long it has not become shorter [s]
};

struct TangleCounts {
    std::uint32_t crossings = 0, contours = 0;
    std::uint32_t stalled = 0;  ///< contours that are not pushed any more
};

class Tangles {
  public:
    struct Room {
        std::size_t bodies, particles, pairs, crossings;
    };
    void lay_out(Scratch& scratch, const Room& room);

    /// A step's start.
    struct Start {
        std::span<const ContactBody> bodies;
        std::span<const Vec4> positions;
        const PairList& near;  ///< within the reach of what pushes features apart
        float h;               ///< of the step [s]
    };
    /// What crosses there. `memory` is of all bodies' particles, in and out. Crossings must be all there
    /// are; where more are listed than reserved for, the rest stay as they are.
    void find(const Start& start, const CrossingList& crossings, std::span<TangleMemory> memory);
    /// Without a search: what particles remember of one.
    void recall(std::span<const ContactBody> bodies, std::span<const TangleMemory> memory);
    /// Nothing crosses, or did of late.
    void clear() noexcept { active_ = false; }

    /// Whether anything crosses, or did of late; else no pair is exempt.
    [[nodiscard]] bool any() const noexcept { return active_; }
    /// exempt[pair] = 1 where both features are near a common contour, else 0.
    void exempt(Parallel& parallel, const PairList& pairs, std::span<std::uint8_t> exempt) const;
    [[nodiscard]] std::span<const UntanglingRow> rows() const noexcept {
        return active_ ? untangling_.rows() : std::span<const UntanglingRow>();
    }
    [[nodiscard]] TangleCounts counts() const noexcept { return active_ ? counts_ : TangleCounts(); }

  private:
    struct Label {
        std::uint32_t particle, contour;
        friend auto operator<=>(const Label&, const Label&) = default;
    };
    void find_core(std::span<const Crossing> crossings);
    void name_contours(const Start& start, std::span<const Crossing> crossings,
                       std::span<const TangleMemory> memory);
    std::uint32_t push_by_votes(std::uint32_t contour, std::span<const Crossing> crossings);
    void dilate(std::span<const ContactBody> bodies);
    void remember(std::span<TangleMemory> memory);
    void forget(std::span<const ContactBody> bodies, std::span<TangleMemory> memory);
    void stop_stalled();
    [[nodiscard]] bool share_contour(const FeaturePair& pair, std::uint32_t corners_of_a) const;
    [[nodiscard]] bool share_contour(std::uint32_t a, std::uint32_t b) const;

    Contours contours_;
    Untangling untangling_;
    SideVote side_vote_;
    ScratchArray<Label> core_;                // of crossing features: by contour, then particle
    ScratchArray<Label> labels_;              // with those near them: by particle
    ScratchArray<std::uint32_t> label_ends_;  // of particles; the first is where the one before ends
    ScratchArray<std::uint32_t> names_;       // of particles; 0: without one
    ScratchArray<std::uint32_t> marks_;       // of particles: the last contour that has it, plus one
    ScratchArray<TangleMemory> of_contours_;
    std::uint32_t core_size_ = 0, label_count_ = 0;
    TangleCounts counts_;
    bool active_ = false;
};

}  // namespace weft
