#pragma once
// What a search lists beside what brute force lists.

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/collision/contact/pair_finder_scenes.h"
#include "tests/laid_out.h"

namespace weft::test {

using Corners = std::array<std::uint32_t, 4>;

/// The same for a pair of edges in any order.
inline Corners key_of(Corners c, bool vertex_triangle) {
    if (vertex_triangle) {
        std::sort(c.begin() + 1, c.end());
    } else {
        if (c[0] > c[1]) std::swap(c[0], c[1]);
        if (c[2] > c[3]) std::swap(c[2], c[3]);
        if (c[0] > c[2] || (c[0] == c[2] && c[1] > c[3])) c = {c[2], c[3], c[0], c[1]};
    }
    return c;
}

/// visit(corners, corners of A, reach) for every pair that may be listed.
template <class Visit>
void for_each_pair(const ContactScene& scene, const Visit& visit) {
    for (const ContactBody& a : scene.bodies) {
        for (const ContactBody& b : scene.bodies) {
            if (!meet(a, b)) continue;
            const double reach = 0.5 * (double{a.reach} + double{b.reach});
            std::set<std::uint32_t> vertices;
            for (const Triangle& t : a.mesh->triangles()) vertices.insert(t.begin(), t.end());
            for (const Triangle& t : b.mesh->triangles())
                for (const std::uint32_t v : vertices) {
                    const Corners c = {a.first + v, b.first + t[0], b.first + t[1], b.first + t[2]};
                    if (c[0] != c[1] && c[0] != c[2] && c[0] != c[3]) visit(c, std::size_t(1), reach);
                }
            if (&b < &a) continue;
            const auto& edges = a.mesh->edges();
            for (std::size_t e = 0; e < edges.size(); ++e)
                for (std::size_t f = &a == &b ? e + 1 : 0; f < b.mesh->edges().size(); ++f) {
                    const auto& p = edges[e];
                    const auto& q = b.mesh->edges()[f];
                    const Corners c = {a.first + p[0], a.first + p[1], b.first + q[0], b.first + q[1]};
                    if (c[0] != c[2] && c[0] != c[3] && c[1] != c[2] && c[1] != c[3])
                        visit(c, std::size_t(2), reach);
                }
        }
    }
}

/// What may be missed or added at the very edge of reach; and how far apart two must be for their normal to
/// be sure, relative to it.
inline constexpr double margin = 1e-4, sure = 2e-3;

inline void expect_same_pairs(const ContactScene& scene, std::size_t at_least = 0) {
    const LaidOut<PairList> list = pairs_of(scene);
    ASSERT_FALSE(list.overflowed);
    EXPECT_GE(list.size, at_least);
    std::map<Corners, std::uint32_t> listed[2];
    for (std::uint32_t k = 0; k < list.size; ++k) {
        const bool vt = k < list.vertex_triangle;
        const bool is_new = listed[vt].emplace(key_of(list.pairs[k].corners, vt), k).second;
        EXPECT_TRUE(is_new) << "listed twice";
    }
    std::size_t missed = 0, added = 0, known = 0, wrong = 0;
    for_each_pair(scene, [&](const Corners& c, std::size_t of_a, double reach) {
        const ReferencePair pair = reference_pair(c, of_a, scene.positions, scene.motions);
        const auto& of_kind = listed[of_a == 1];
        const auto at = of_kind.find(key_of(c, of_a == 1));
        const bool is_listed = at != of_kind.end();
        known += is_listed;
        const bool is_sure = pair.distance > sure * reach;
        const bool near = pair.swept_gap < reach * (1 - margin) && pair.box_gap < reach * (1 - margin);
        const bool far = pair.swept_gap > reach * (1 + margin);
        missed += near && is_sure && !is_listed;
        added += far && is_sure && is_listed;
        if (!is_listed) return;
        const PairShape& shape = list.shapes[at->second];
        const Vec4& w = shape.weights;
        const double length = in_double(shape.normal).norm();
        const std::array<float, 4> weights = {w.x, w.y, w.z, w.w};
        Vector3d gap(0, 0, 0);
        const Corners& own = list.pairs[at->second].corners;
        for (std::size_t k = 0; k < 4; ++k)
            gap += double{weights[k]} *
                   (in_double(scene.positions[own[k]]) - in_double(scene.positions[own[0]]));
        const bool is_right = std::abs(length - 1) < 1e-5 && std::abs(w.x + w.y + w.z + w.w) < 1e-5f &&
                              std::abs(double(shape.normal.w) - pair.distance) < margin * reach &&
                              std::abs(gap.norm() - pair.distance) < margin * reach;
        wrong += is_sure && !is_right;
    });
    EXPECT_EQ(missed, 0u);
    EXPECT_EQ(added, 0u);
    EXPECT_EQ(wrong, 0u);
    EXPECT_EQ(known, list.size) << "pairs that share a vertex, or of bodies that do not meet";
}

}  // namespace weft::test
