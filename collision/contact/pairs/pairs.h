#pragma once
// Pairs of features that are near: a vertex and a triangle, or two edges. All that follows detection is the
// same for both kinds: sides A and B, and a gap that is a weighted sum of four corners.

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

/// How a pair lies at the start; normals of moving pairs may be turned, see shape_moving_pairs(). The gap
/// vector, from the closest point of B to that of A, is the sum of weights times corners: (1, -w1, -w2, -w3)
/// or (1 - s, s, -(1 - t), -t).
struct PairShape {
    Vec4 weights;
    /// Unit normal from B to A; w [m]: min over A of n . x - max over B of n . x. Where it is positive the
    /// two are apart, and a plane across n is between them.
    Vec4 normal;

    /// Whether the closest points are at a triangle's border or at an end of an edge: where surfaces are
    /// smooth, features beside these are nearer.
    [[nodiscard]] bool is_at_border() const noexcept {
        return weights.x == 0 || weights.y == 0 || weights.z == 0 || weights.w == 0;
    }
    [[nodiscard]] float weight(std::uint32_t corner) const noexcept {
        return std::array{weights.x, weights.y, weights.z, weights.w}[corner];
    }
};

/// In an order that no thread decides: first all pairs of vertex and triangle, then all of edges.
struct PairList {
    ScratchArray<FeaturePair> pairs;
    ScratchArray<PairShape> shapes;
    std::uint32_t size = 0;
    std::uint32_t vertex_triangle = 0;  ///< of these
    /// There were more pairs than there is room for: what is listed is not all.
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
    /// How many of a pair's corners are side A: the first so many.
    [[nodiscard]] std::uint32_t corners_of_a(std::uint32_t pair) const noexcept {
        return pair < vertex_triangle ? 1 : 2;
    }
};

}  // namespace weft
