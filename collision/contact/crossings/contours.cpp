#include "collision/contact/crossings/contours.h"

#include <algorithm>
#include <utility>

namespace weft {

std::size_t body_of(std::span<const ContactBody> bodies, std::uint32_t particle) {
    const auto next = std::ranges::upper_bound(bodies, particle, {}, &ContactBody::first);
    return static_cast<std::size_t>(next - bodies.begin()) - 1;
}

namespace {

/// Index in the mesh of the triangle that has these corners.
std::uint32_t triangle_with(const ContactBody& body, const std::array<std::uint32_t, 3>& corners) {
    for (const std::uint32_t t : body.mesh->triangles_of(corners[0] - body.first)) {
        const ContactMesh::Triangle& other = body.mesh->triangles()[t];
        const auto has = [&](std::uint32_t i) {
            return std::ranges::find(other, i - body.first) != other.end();
        };
        if (has(corners[1]) && has(corners[2])) return t;
    }
    return 0;
}

// Room for segments: an edge of cloth has at most two triangles. Segments beyond the room are left out.
constexpr std::size_t segments_per_crossing = 2;

}  // namespace

void Contours::lay_out(Scratch& scratch, std::size_t bodies, std::size_t crossings) {
    scratch.take(first_triangle_, bodies);
    scratch.take(segments_, segments_per_crossing * crossings);
    for (auto* buffer : {&parents_, &sides_, &contours_, &firsts_, &next_}) scratch.take(*buffer, crossings);
}

void Contours::trace(std::span<const ContactBody> bodies, std::span<const Crossing> crossings) {
    find_segments(bodies, crossings);
    const auto count = static_cast<std::uint32_t>(crossings.size());
    for (std::uint32_t k = 0; k < count; ++k) {
        parents_[k] = k;
        sides_[k] = 0;
    }
    for (std::uint32_t s = 0; s + 1 < segment_count_; ++s)
        if (segments_[s].triangles == segments_[s + 1].triangles) join(segments_[s], segments_[s + 1]);

    // join() keeps the lower of two roots, so a contour's first crossing is its root.
    size_ = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
        const Root root = root_of(k);
        contours_[k] = root.crossing == k ? size_++ : contours_[root.crossing];
    }
    std::fill_n(firsts_.data(), size_, none);
    for (std::uint32_t k = count; k-- > 0;) next_[k] = std::exchange(firsts_[contours_[k]], k);
}

void Contours::find_segments(std::span<const ContactBody> bodies, std::span<const Crossing> crossings) {
    std::uint32_t triangles = 0;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        first_triangle_[k] = triangles;
        triangles += static_cast<std::uint32_t>(bodies[k].mesh->triangles().size());
    }
    segment_count_ = 0;
    for (std::uint32_t k = 0; k < crossings.size(); ++k) {
        const std::size_t of_edge = body_of(bodies, crossings[k].edge[0]);
        const std::size_t of_triangle = body_of(bodies, crossings[k].triangle[0]);
        const std::uint32_t through =
            first_triangle_[of_triangle] + triangle_with(bodies[of_triangle], crossings[k].triangle);
        for_each_beside(bodies[of_edge], crossings[k].edge, [&](std::uint32_t t, std::uint32_t) {
            if (segment_count_ == segments_.size()) return;
            const std::uint32_t beside = first_triangle_[of_edge] + t;
            const std::uint64_t low = std::min(beside, through), high = std::max(beside, through);
            segments_[segment_count_++] = {low << 32 | high, k, beside > through ? 1u : 0u};
        });
    }
    std::ranges::sort(segments_.span().first(segment_count_), [](const Segment& a, const Segment& b) {
        return a.triangles != b.triangles ? a.triangles < b.triangles : a.crossing < b.crossing;
    });
}

// Finds the root, with path compression. A crossing's side is relative to its parent's.
Contours::Root Contours::root_of(std::uint32_t crossing) {
    std::uint32_t root = crossing, side = 0;
    for (; parents_[root] != root; root = parents_[root]) side ^= sides_[root];
    for (std::uint32_t k = crossing, left = side; parents_[k] != k;) {
        const std::uint32_t parent = parents_[k], own = sides_[k];
        parents_[k] = root;
        sides_[k] = left;
        left ^= own;
        k = parent;
    }
    return {root, side};
}

// The edges of two crossings may belong to different triangles of the two: their sides then differ. Along the
// contour of a surface that crosses itself, sides may disagree; those joined first count.
void Contours::join(const Segment& a, const Segment& b) {
    const Root of_a = root_of(a.crossing), of_b = root_of(b.crossing);
    if (of_a.crossing == of_b.crossing) return;
    const std::uint32_t low = std::min(of_a.crossing, of_b.crossing);
    const std::uint32_t high = std::max(of_a.crossing, of_b.crossing);
    parents_[high] = low;
    sides_[high] = of_a.side ^ of_b.side ^ a.edge_is_of_higher ^ b.edge_is_of_higher;
}

}  // namespace weft
