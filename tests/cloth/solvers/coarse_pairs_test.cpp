// Coarse rows of contact, against sums over pairs in double precision.

#include "cloth/solver/levels/coarse/coarse_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "tests/cloth/system/pair_scene.h"
#include "tests/laid_out.h"

namespace weft::test {
namespace {

/// Each particle is a coarse node, and so are neighbours of it, by `spread`; what is pinned has no weights.
Interpolation interpolation(const PairScene& scene, std::uint32_t first, std::uint32_t count, float spread) {
    constexpr std::uint32_t width = Interpolation::width;
    Interpolation p(count, count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::array<float, width> weights{1 - spread, 0.75f * spread, 0.25f * spread};
        for (std::uint32_t k = 0; k < width; ++k) {
            p.nodes[width * i + k] = (i + k) % count;
            p.weights[width * i + k] = scene.positions[first + i].w > 0 ? weights[k] : 0;
        }
    }
    return p;
}

/// What CoarsePairs says that it computes: rows between the same two nodes, by their numbers.
struct Reference {
    struct Row {
        std::vector<double> weights;
        Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
        int merged = 0;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Row> rows;
    bool has_outer = false;

    Reference(const PairRows& pairs, std::uint32_t first, const Interpolation& p) {
        pairs.for_each_active([&](const PairRows::ActivePair& active) { add(active, first, p); });
    }

  private:
    static constexpr int looked_at = 4;

    void add(const PairRows::ActivePair& active, std::uint32_t first, const Interpolation& p) {
        const auto is_outer = [&](std::uint32_t corner) { return corner - first >= p.fine; };
        const auto outer = std::ranges::count_if(active.pair.corners, is_outer);
        has_outer = has_outer || (outer > 0 && outer < 4);
        if (outer > 0) return;
        const auto transposed = [&](const std::vector<std::uint32_t>& corners, bool by_signs) {
            std::vector<double> c(p.coarse);
            for (const std::uint32_t k : corners)
                for (std::uint32_t e = 0; e < Interpolation::width; ++e) {
                    const std::uint32_t at = Interpolation::width * (active.pair.corners[k] - first) + e;
                    const float weight = active.shape.weight(k);
                    c[p.nodes[at]] += static_cast<double>(p.weights[at] *
                                                          (by_signs ? std::copysign(1.0f, weight) : weight));
                }
            return c;
        };
        std::uint32_t most = 0, least = 0;
        for (std::uint32_t k = 1; k < 4; ++k) {
            if (active.shape.weight(k) > active.shape.weight(most)) most = k;
            if (active.shape.weight(k) < active.shape.weight(least)) least = k;
        }
        const std::vector<double> ends = transposed({most, least}, true);
        const auto high = std::ranges::max_element(ends), low = std::ranges::min_element(ends);
        if (*high <= 0 && *low >= 0) return;
        const auto a = static_cast<std::uint32_t>((*high > 0 ? high : low) - ends.begin());
        const auto b = static_cast<std::uint32_t>((*low < 0 ? low : high) - ends.begin());
        Row& row = rows[{std::min(a, b), std::max(a, b)}];
        row.stiffness += active.stiffness().full();
        row.weights.resize(p.coarse);
        if (++row.merged > looked_at) return;
        const std::vector<double> c = transposed({0, 1, 2, 3}, false);
        for (std::uint32_t i = 0; i < p.coarse; ++i) row.weights[i] += (a <= b ? 1 : -1) * c[i];
    }
};

struct Gathered {
    Linearised linearised;
    Interpolation p;
    LaidOut<CoarsePairs> pairs;

    Gathered(const PairScene& scene, std::uint32_t first, std::uint32_t count, float spread, int threads = 1)
        : linearised(scene, threads), p(interpolation(scene, first, count, spread)) {
        pairs.reserve(scene.pairs.size, count);
        const Numbering::Range range{first, 0, count};
        pairs.list(linearised.rows, Numbering({&range, 1}));
        pairs.gather(linearised.parallel, Numbering({&range, 1}), {p});
    }
};

TEST(CoarsePairs, AreThePairsBetweenTheSameNodesInOne) {
    constexpr std::uint32_t particles = 101;  // of most pairs there are more than there is room for
    for (const std::uint32_t count : {40u, 400u, 20000u}) {
        const PairScene scene(particles, count);
        const Gathered gathered(scene, 0, particles, 0);
        const Reference reference(gathered.linearised.rows, 0, gathered.p);
        auto row = gathered.pairs.rows().begin();
        const auto end = gathered.pairs.rows().end();
        std::size_t of_reference = 0;
        for (const auto& [nodes, expected] : reference.rows) {
            if (of_reference++ == gathered.pairs.room()) break;
            double reach = 0;
            for (const double w : expected.weights) reach += std::abs(w);
            reach /= std::min(expected.merged, 4);
            if (reach < 0.1) continue;  // it says nothing that the level could move by
            ASSERT_NE(row, end) << nodes.first << " " << nodes.second;
            std::vector<double> weights(particles);
            for (std::uint32_t k = 0; k < row->count; ++k)
                weights[row->nodes[k]] += static_cast<double>(row->weights[k]);
            for (std::size_t i = 0; i < weights.size(); ++i)
                EXPECT_NEAR(weights[i], expected.weights[i] / std::min(expected.merged, 4), 1e-5);
            EXPECT_LT((row->stiffness.full() - expected.stiffness).norm(), 1e-5 * expected.stiffness.norm());
            EXPECT_NEAR(static_cast<double>(row->reach), reach, 1e-5);
            ++row;
        }
        EXPECT_EQ(row, end) << count << " pairs";
        EXPECT_FALSE(gathered.pairs.has_outer());
    }
}

TEST(CoarsePairs, OfOneClothLeaveOutWhatIsBetweenItAndOthers) {
    const PairScene scene(53, 400);
    const Gathered gathered(scene, 16, 32, 0);
    const Reference reference(gathered.linearised.rows, 16, gathered.p);
    EXPECT_TRUE(reference.has_outer);
    EXPECT_TRUE(gathered.pairs.has_outer());
    EXPECT_GT(gathered.pairs.rows().size(), 0u);
    EXPECT_EQ(gathered.pairs.rows().size(), reference.rows.size());
}

}  // namespace
}  // namespace weft::test
