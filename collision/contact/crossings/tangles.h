#pragma once
// Tangles: cloth that crosses cloth at the start of a step. The contact response lets nothing cross and would
// preserve them for ever: their pairs are exempt from it, and the crossing surfaces are pushed apart.

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

/// A particle's record of the contour that it was last near; all 0 without one.
struct TangleMemory {
    std::uint32_t name;   ///< the contour's number, which it keeps from step to step
    std::uint32_t steps;  ///< steps away from any contour until the record is erased
    std::uint32_t least;  ///< fewest crossings that the contour has had; see `votes`
    std::uint32_t votes;  ///< 1: votes direct the contour, and votes of the minority count as crossings
    float stalled;        ///< time for which the contour has not become shorter [s]

    /// Separated features stay exempt for this number of steps, so that the next crossing does not catch
    /// them.
    static constexpr std::uint32_t steps_remembered = 2;
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

    /// State at the start of a step.
    struct Start {
        std::span<const ContactBody> bodies;
        std::span<const Vec4> positions;
        const PairList& near;  ///< pairs within the reach of the forces that push features apart
        float h;               ///< length of the step [s]
    };
    /// Finds the contours, makes their rows, and updates `memory`, which is of all bodies' particles.
    /// `crossings` must be complete; those beyond the reserved room stay as they are.
    void find(const Start& start, const CrossingList& crossings, std::span<TangleMemory> memory);
    /// Takes the tangles from the particles' memory, without a search: there are exempt pairs, but no rows.
    void recall(std::span<const ContactBody> bodies, std::span<const TangleMemory> memory);
    /// For a step without crossings now or in the remembered steps.
    void clear() noexcept { active_ = false; }

    /// Whether anything crosses, or did in the remembered steps. If not, no pair is exempt.
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
    ScratchArray<Label> core_;                // corners of crossing features: by contour, then particle
    ScratchArray<Label> labels_;              // these and the ring around them: by particle
    ScratchArray<std::uint32_t> label_ends_;  // per particle: end of its labels, begin of the next one's
    ScratchArray<std::uint32_t> names_;       // per particle: the remembered name, 0: none
    ScratchArray<std::uint32_t> marks_;       // per particle: the last contour that labelled it, plus one
    ScratchArray<TangleMemory> of_contours_;
    std::uint32_t core_size_ = 0, label_count_ = 0;
    TangleCounts counts_;
    bool active_ = false;
};

}  // namespace weft
