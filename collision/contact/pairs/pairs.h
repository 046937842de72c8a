#pragma once
// Pairs of features that are near: a vertex and a triangle, or two edges. After detection both kinds are
// treated alike: sides A and B, and a gap that is a weighted sum of four corners.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/memory/scratch.h"
#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

/// A vertex (corner 0) and a triangle (corners 1 to 3), or two edges (corners 0, 1 and 2, 3).
struct FeaturePair {
    std::array<std::uint32_t, 4> corners;  ///< particles, numbered through all bodies
};

/// Geometry of a pair at the start; shape_moving_pairs() may turn the normal. The gap vector, from the
/// closest point of B to that of A, is the sum of weights times corners: (1, -w1, -w2, -w3) or
/// (1 - s, s, -(1 - t), -t).
struct PairShape {
    Vec4 weights;
    /// Unit normal from B to A; w: the gap [m], min over A of n . x - max over B of n . x. If it is positive,
    /// a plane across n separates the two.
    Vec4 normal;

    /// Whether a closest point is at a triangle's border or at an end of an edge. On a smooth surface, a
    /// feature beside that one is then nearer.
    [[nodiscard]] bool is_at_border() const noexcept {
        return weights.x == 0 || weights.y == 0 || weights.z == 0 || weights.w == 0;
    }
    [[nodiscard]] float weight(std::uint32_t corner) const noexcept {
        return std::array{weights.x, weights.y, weights.z, weights.w}[corner];
    }
};

/// Pairs of vertex and triangle, then pairs of edges. Their order does not depend on threads.
struct PairList {
    ScratchArray<FeaturePair> pairs;
    ScratchArray<PairShape> shapes;
    std::uint32_t size = 0;
    std::uint32_t vertex_triangle = 0;  ///< number of pairs of vertex and triangle
    /// Whether there were more pairs than room: the list is incomplete.
    bool overflowed = false;

    void lay_out(Scratch& scratch, std::size_t capacity) {
        scratch.take(pairs, capacity);
        scratch.take(shapes, capacity);
    }
    void clear() noexcept {
        size = vertex_triangle = 0;
        overflowed = false;
    }
    [[nodiscard]] std::size_t capacity() const noexcept { return pairs.size(); }
    /// Number of a pair's corners on side A, which come first.
    [[nodiscard]] std::uint32_t corners_of_a(std::uint32_t pair) const noexcept {
        return pair < vertex_triangle ? 1 : 2;
    }
};

}  // namespace weft
