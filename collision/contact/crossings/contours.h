#pragma once
// Contours: the curves along which surfaces cross, assembled from crossings of edges and triangles.

#include <array>
#include <cstdint>
#include <span>

#include "collision/contact/pairs/crossings.h"
#include "collision/contact/pairs/pair_finder.h"
#include "engine/memory/scratch.h"

namespace weft {

/// Two triangles that cross share a segment of a curve; at each of its ends, an edge of one passes through
/// the other. Two crossings of the same two triangles are therefore neighbours on their curve. One of the two
/// surfaces that cross along a contour is side 0 throughout, the other is side 1.
class Contours {
  public:
    void lay_out(Scratch& scratch, std::size_t bodies, std::size_t crossings);

    /// Assembles the contours. The crossings must be those of these bodies, no more than lay_out() reserved.
    void trace(std::span<const ContactBody> bodies, std::span<const Crossing> crossings);

    [[nodiscard]] std::uint32_t size() const noexcept { return size_; }  ///< contours
    /// The crossing's contour. Contours are numbered in the order in which their first crossings are listed.
    [[nodiscard]] std::uint32_t contour_of(std::uint32_t crossing) const noexcept {
        return contours_[crossing];
    }
    /// Calls visit(crossing) for the crossings of a contour, in ascending order.
    template <class Visit>
    void for_each_crossing(std::uint32_t contour, const Visit& visit) const {
        for (std::uint32_t k = firsts_[contour]; k != none; k = next_[k]) visit(k);
    }
    /// The side, 0 or 1, of the crossing's edge. The triangle belongs to the other side.
    [[nodiscard]] std::uint32_t side_of_edge(std::uint32_t crossing) const noexcept {
        return sides_[crossing];
    }

  private:
    static constexpr std::uint32_t none = ~0u;
    struct Segment {
        std::uint64_t triangles;  // the lower index in the upper 32 bits, the higher in the lower
        std::uint32_t crossing;
        std::uint32_t edge_is_of_higher;
    };
    struct Root {
        std::uint32_t crossing, side;
    };
    void find_segments(std::span<const ContactBody> bodies, std::span<const Crossing> crossings);
    Root root_of(std::uint32_t crossing);
    void join(const Segment& a, const Segment& b);

    ScratchArray<std::uint32_t> first_triangle_;  // per body: index of its first triangle among all
    ScratchArray<Segment> segments_;
    std::uint32_t segment_count_ = 0;
    ScratchArray<std::uint32_t> parents_, sides_, contours_;  // per crossing; sides_: against the parent
    ScratchArray<std::uint32_t> firsts_, next_;               // linked lists: contour's head, crossing's next
    std::uint32_t size_ = 0;
};

/// Index of the body that has the particle. The bodies must ascend by their first particles.
[[nodiscard]] std::size_t body_of(std::span<const ContactBody> bodies, std::uint32_t particle);

/// Calls visit(triangle of the mesh, third corner among all bodies) for the triangles beside an edge.
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
