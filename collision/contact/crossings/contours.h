#pragma once
// Where surfaces cross, as curves: crossings of edges and triangles, put together.

#include <array>
#include <cstdint>
#include <span>

#include "collision/contact/pairs/crossings.h"
#include "collision/contact/pairs/pair_finder.h"
#include "engine/memory/scratch.h"

namespace weft {

/// Two triangles that cross share a segment of a curve, and each end of it is where an edge of one goes
/// through the other. So two crossings of the same two triangles follow one another on their curve. Of the
/// two surfaces that cross along it, one is side 0 all along and the other is side 1.
class Contours {
  public:
    void lay_out(Scratch& scratch, std::size_t bodies, std::size_t crossings);

    /// Crossings must be those of these bodies, no more than reserved for.
    void trace(std::span<const ContactBody> bodies, std::span<const Crossing> crossings);

    [[nodiscard]] std::uint32_t size() const noexcept { return size_; }  ///< contours
    /// Numbered in the order in which their first crossings are listed.
    [[nodiscard]] std::uint32_t contour_of(std::uint32_t crossing) const noexcept {
        return contours_[crossing];
    }
    /// visit(crossing) for those of a contour, ascending.
    template <class Visit>
    void for_each_crossing(std::uint32_t contour, const Visit& visit) const {
        for (std::uint32_t k = firsts_[contour]; k != none; k = next_[k]) visit(k);
    }
    /// On which side the crossing's edge is. The triangle is on the other.
    [[nodiscard]] std::uint32_t side_of_edge(std::uint32_t crossing) const noexcept {
        return sides_[crossing];
    }

  private:
    static constexpr std::uint32_t none = ~0u;
    struct Segment {
        std::uint64_t triangles;  // the lower, then the higher
        std::uint32_t crossing;
        std::uint32_t edge_is_of_higher;
    };
    struct Root {
        std::uint32_t crossing, side;
    };
    void find_segments(std::span<const ContactBody> bodies, std::span<const Crossing> crossings);
    Root root_of(std::uint32_t crossing);
    void join(const Segment& a, const Segment& b);

    ScratchArray<std::uint32_t> first_triangle_;  // of bodies
    ScratchArray<Segment> segments_;
    std::uint32_t segment_count_ = 0;
    ScratchArray<std::uint32_t> parents_, sides_, contours_;  // of crossings; sides: against the parent's
    ScratchArray<std::uint32_t> firsts_, next_;  // of contours, of crossings: those of a contour, as a list
    std::uint32_t size_ = 0;
};

/// Which of the bodies, in ascending order of their first particles, has the particle.
[[nodiscard]] std::size_t body_of(std::span<const ContactBody> bodies, std::uint32_t particle);

/// visit(triangle of the mesh, third corner of all bodies) for the triangles beside an edge.
template <class Visit>
void for_each_beside(const ContactBody& body, const std::array<std::uint32_t, 2>& edge, const Visit& visit) {
    const std::uint32_t a = edge[0] - body.first, b = edge[1] - body.first;
    for (const std::uint32_t t : body.mesh->triangles_of(a)) {
        const ContactMesh::Triangle& corners = body.mesh->triangles()[t];
        bool has_b = false;
        std::uint32_t third = a;
        for (const std::uint32_t i : corners) {
            has_b = has_b || i == b;
            if (i != a && i != b) third = i;
        }
        if (has_b) visit(t, body.first + third);
    }
}

}  // namespace weft
