#pragma once
// Direction in which crossing layers separate where their contour gives none: a contour that is straight, or
// ends within a surface, grows shorter in no direction.

#include <cstdint>
#include <span>

#include "collision/contact/crossings/contours.h"
#include "collision/contact/pairs/crossings.h"
#include "collision/contact/pairs/pairs.h"
#include "engine/memory/scratch.h"
#include "engine/vector.h"

namespace weft {

/// Pairs of features near a contour vote for the side of one surface on which the other lies. Pairs on the
/// contour's two sides vote for opposite sides, and the majority wins. All contours of a step share one
/// budget of spreads, which one alone may use up: of hundreds on crumpled cloth, the later ones count only
/// pairs that are near.
class SideVote {
  public:
    void lay_out(Scratch& scratch, std::size_t particles, std::size_t pairs);

    /// Prepares votes on contours of these bodies. The arguments must outlive the calls of of().
    void begin(std::span<const ContactBody> bodies, std::span<const Vec4> positions, const PairList& pairs);

    struct Result {
        /// Where side 0 belongs: 1: on that side of side 1 to which its triangles' normals point; -1: on the
        /// opposite side; 0: no votes, or a tie.
        float side = 0;
        std::uint32_t minority = 0;  ///< number of votes for the other side
    };
    [[nodiscard]] Result of(std::uint32_t contour, std::span<const Crossing> crossings,
                            const Contours& contours);

    /// Unit direction in which the crossing's edge has to move relative to its triangle.
    [[nodiscard]] Vector3 way_of(const Crossing& crossing, std::uint32_t side_of_edge, float side) const;

  private:
    struct Member {
        std::uint32_t particle, side;
    };
    void join(std::uint32_t particle, std::uint32_t side);
    void spread(const Member& member);
    [[nodiscard]] bool meets(std::uint32_t particle, std::uint32_t side);
    [[nodiscard]] float opinion_of(const Member& member, std::uint32_t pair) const;
    [[nodiscard]] bool is_on(std::uint32_t particle, std::uint32_t side) const noexcept {
        return (sides_[particle] >> side & 1) != 0;
    }
    [[nodiscard]] bool any_corner_is_on(const FeaturePair& pair, std::uint32_t side) const noexcept {
        return is_on(pair.corners[1], side) || is_on(pair.corners[2], side) || is_on(pair.corners[3], side);
    }
    /// Indices of the vertex's pairs with triangles.
    [[nodiscard]] std::span<const std::uint32_t> pairs_of(std::uint32_t vertex) const {
        return order_.span().subspan(starts_[vertex], starts_[vertex + 1] - starts_[vertex]);
    }
    [[nodiscard]] Vector3 normal_at(std::uint32_t particle) const;

    std::span<const ContactBody> bodies_;
    std::span<const Vec4> positions_;
    const PairList* pairs_ = nullptr;
    ScratchArray<std::uint32_t> starts_, order_;  // indices of pairs, sorted by vertex
    ScratchArray<std::uint8_t> sides_;            // per particle: bit s is set on side s; 0 between votes
    ScratchArray<Member> members_;
    std::uint32_t member_count_ = 0, spreads_left_ = 0;
};

}  // namespace weft
