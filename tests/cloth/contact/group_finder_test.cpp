// Which cloths may touch, against brute force.

#include "cloth/contact/group_finder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "engine/bounds.h"

namespace weft::test {
namespace {

/// Labels spread from pair to pair until none changes.
template <class MayTouch>
std::vector<std::uint32_t> by_brute_force(std::span<const Bounds> boxes, const MayTouch& may_touch) {
    std::vector<std::uint32_t> labels(boxes.size());
    std::iota(labels.begin(), labels.end(), 0u);
    for (bool changed = true; std::exchange(changed, false);) {
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
                if (labels[i] == labels[j] || !overlap(boxes[i], boxes[j]) || !may_touch(i, j)) continue;
                labels[i] = labels[j] = std::min(labels[i], labels[j]);
                changed = true;
            }
        }
    }
    return labels;
}

std::vector<Bounds> random_boxes(std::size_t count, float size, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(0, 1), side(0, size);
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 p{place(random), place(random), place(random)};
        boxes.push_back({p, {p.x + side(random), p.y + side(random), p.z + side(random)}});
    }
    return boxes;
}

TEST(Groups, AreThoseOfBruteForce) {
    const auto any = [](std::uint32_t, std::uint32_t) { return true; };
    const auto of_a_layer = [](std::uint32_t i, std::uint32_t j) { return i % 3 == j % 3; };
    GroupFinder groups;
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        for (const float size : {0.0f, 0.05f, 0.2f, 0.6f}) {
            std::vector<Bounds> boxes = random_boxes(1 + 7 * seed, size, seed);
            boxes.push_back({{1, 1, 1}, {0, 0, 0}});  // empty: touches none
            boxes.push_back(boxes.front());           // coincident
            groups.find(boxes, any);
            EXPECT_TRUE(std::ranges::equal(groups.first_of(), by_brute_force(boxes, any)));
            groups.find(boxes, of_a_layer);
            EXPECT_TRUE(std::ranges::equal(groups.first_of(), by_brute_force(boxes, of_a_layer)));
        }
    }
}

}  // namespace
}  // namespace weft::test
