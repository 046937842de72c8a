#pragma once
// Which way crossing layers have to go where the curve along which they cross tells nothing: where it is
// straight, or ends within a surface, it grows no shorter whichever way it goes.

#include <cstdint>
#include <span>

#include "collision/contact/crossings/contours.h"
#include "collision/contact/pairs/crossings.h"
#include "collision/contact/pairs/pairs.h"
#include "engine/memory/scratch.h"
#include "engine/vector.h"

namespace weft {

/// Pairs of features beside a contour say which of its surfaces lies on which side of the other. On the two
/// sides of the contour they say the opposite, and the more are taken for right. In one step all contours
/// together reach as far from where they cross as one alone may: of hundreds on crumpled cloth the later ask
/// only what is near.
class SideVote {
  public:
    void lay_out(Scratch& scratch, std::size_t particles, std::size_t pairs);

    /// Votes are to follow, of these bodies. What is given must outlive them.
    void begin(std::span<const ContactBody> bodies, std::span<const Vec4> positions, const PairList& pairs);

    struct Result {
        /// Where side 0 of the contour belongs: 1: on the side of side 1 to which its triangles' normals
        /// point, -1: on the other; 0: nobody voted, or as many for both.
        float side = 0;
        std::uint32_t minority = 0;  ///< pairs that lie the other way
    };
    [[nodiscard]] Result of(std::uint32_t contour, std::span<const Crossing> crossings,
                            const Contours& contours);

    /// Of unit length: the way on which the crossing's edge has to go against its triangle.
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
    /// Pairs of the vertex and a triangle.
    [[nodiscard]] std::span<const std::uint32_t> pairs_of(std::uint32_t vertex) const {
        return order_.span().subspan(starts_[vertex], starts_[vertex + 1] - starts_[vertex]);
    }
    [[nodiscard]] Vector3 normal_at(std::uint32_t particle) const;

    std::span<const ContactBody> bodies_;
    std::span<const Vec4> positions_;
    const PairList* pairs_ = nullptr;
    ScratchArray<std::uint32_t> starts_, order_;  // by vertex: which pairs it is in
    ScratchArray<std::uint8_t> sides_;            // of particles: bits; 0 between votes
    ScratchArray<Member> members_;
    std::uint32_t member_count_ = 0, spreads_left_ = 0;
};

}  // namespace weft
