// Which cloths may touch, against brute force; and cloths that do, by a stand-in for contact between them.

#include "cloth/frame/islands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <numeric>
#include <random>

#include "fixtures.h"

namespace weft::test {
namespace {

bool overlap(const Bounds& a, const Bounds& b) {
    const auto along = [](float a0, float a1, float b0, float b1) { return a0 <= b1 && b0 <= a1; };
    return along(a.lower.x, a.upper.x, b.lower.x, b.upper.x) &&
           along(a.lower.y, a.upper.y, b.lower.y, b.upper.y) &&
           along(a.lower.z, a.upper.z, b.lower.z, b.upper.z);
}

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

TEST(Islands, AreThoseOfBruteForce) {
    const auto any = [](std::uint32_t, std::uint32_t) { return true; };
    const auto of_a_layer = [](std::uint32_t i, std::uint32_t j) { return i % 3 == j % 3; };
    Islands islands;
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        for (const float size : {0.0f, 0.05f, 0.2f, 0.6f}) {
            std::vector<Bounds> boxes = random_boxes(1 + 7 * seed, size, seed);
            boxes.push_back({{1, 1, 1}, {0, 0, 0}});  // empty: touches none
            boxes.push_back(boxes.front());           // coincident
            islands.find(boxes, any);
            EXPECT_TRUE(std::ranges::equal(islands.first_of(), by_brute_force(boxes, any)));
            islands.find(boxes, of_a_layer);
            EXPECT_TRUE(std::ranges::equal(islands.first_of(), by_brute_force(boxes, of_a_layer)));
        }
    }
}

/// Particles of two cloths that are nearer than a radius are pushed apart along the line between them, each by
/// its share of the mass, and lose the speed at which they approach: every pair, one after the other.
class StandIn final : public Meeting {
  public:
    static constexpr float radius = 0.06f;

    bool may_touch(const Cloth&, const Cloth&) const override { return layers_touch; }
    float reach(const Cloth&) const override { return 0.5f * radius; }
    void meet(Parallel&, std::span<Cloth* const> island, float) override {
        ++meetings;
        cloths += static_cast<int>(island.size());
    }
    void settle(Parallel&, std::span<Cloth* const> island, float) override {
        for (std::size_t a = 0; a < island.size(); ++a)
            for (std::size_t b = a + 1; b < island.size(); ++b) part(island[a]->state, island[b]->state);
    }

    bool layers_touch = true;
    std::atomic<int> meetings = 0, cloths = 0;

  private:
    static void part(ClothState& one, ClothState& other) {
        for (std::uint32_t i = 0; i < one.size(); ++i) {
            for (std::uint32_t j = 0; j < other.size(); ++j) {
                const Vector3 apart = xyz(other.positions[j]) - xyz(one.positions[i]);
                const float distance = apart.norm(), weight = one.positions[i].w + other.positions[j].w;
                if (distance >= radius || distance == 0 || weight == 0) continue;
                const Vector3 n = apart / distance;
                const float push = (radius - distance) / weight;
                const float approach =
                    std::min(0.0f, n.dot(xyz(other.velocities[j]) - xyz(one.velocities[i]))) / weight;
                move(one, i, -push * n, approach * n);
                move(other, j, push * n, -approach * n);
            }
        }
    }
    static void move(ClothState& state, std::uint32_t i, const Vector3& push, const Vector3& impulse) {
        const float w = state.positions[i].w;
        set_xyz(state.positions[i], xyz(state.positions[i]) + w * push);
        set_xyz(state.velocities[i], xyz(state.velocities[i]) + w * impulse);
    }
};

/// Sheets of 0.4 m, 12 particles a side, one above the other, a fifth of a metre apart; the lowest is held at
/// its border.
struct Stack {
    explicit Stack(int count, int threads, bool with_meeting = true) : simulation(settings_of(threads)) {
        if (with_meeting) {
            auto made = std::make_unique<StandIn>();
            stand_in = made.get();
            simulation.meeting = std::move(made);
        }
        for (int k = 0; k < count; ++k) {
            ClothSettings settings;
            settings.substeps = 1 + k % 2;
            const Mesh mesh = make_sheet({.rows = 12,
                                          .columns = 12,
                                          .origin = {-0.2f, 0.2f * static_cast<float>(k), -0.2f},
                                          .u = {0.4f, 0, 0},
                                          .v = {0, 0, 0.4f}})
                                  .value();
            auto cloth = std::make_unique<Cloth>(cook(mesh).value(), settings);
            cloths.push_back(cloth.get());
            simulation.prepare(*cloth);
            simulation.cloths.insert(std::move(cloth));
        }
    }
    static WorldSettings settings_of(int threads) {
        WorldSettings settings = vacuum({0, -9.81f, 0});
        settings.threads = threads;
        settings.substeps = 2;
        return settings;
    }
    void hold_lowest() {
        for (std::uint32_t i = 0; i < 12; ++i)
            for (const std::uint32_t border : {i, 132 + i, 12 * i, 12 * i + 11}) cloths[0]->pin(border);
    }
    [[nodiscard]] std::vector<Vec4> positions() const {
        std::vector<Vec4> all;
        for (const Cloth* cloth : cloths)
            for (const Vec4& x : cloth->state.positions.span()) all.push_back(x);
        return all;
    }

    Simulation simulation;
    StandIn* stand_in = nullptr;
    std::vector<Cloth*> cloths;
};

bool same_bytes(const std::vector<Vec4>& a, const std::vector<Vec4>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec4)) == 0;
}

float mean_height(const Cloth& cloth) {
    float sum = 0;
    for (const Vec4& x : cloth.state.positions.span()) sum += x.y;
    return sum / static_cast<float>(cloth.state.size());
}

TEST(Meeting, ASheetThatFallsOnAnotherStaysOnIt) {
    Stack with(2, 1), without(2, 1, false);
    for (Stack* stack : {&with, &without}) {
        stack->hold_lowest();
        for (int k = 0; k < 90; ++k) stack->simulation.step(1.0f / 60);
    }
    EXPECT_GT(mean_height(*with.cloths[1]), mean_height(*with.cloths[0]));
    EXPECT_GT(mean_height(*with.cloths[1]), -0.3f);
    EXPECT_LT(mean_height(*without.cloths[1]), -5) << "without a meeting it falls through";
}

TEST(Meeting, KeepsTheMomentumOfBoth) {
    Stack stack(2, 1);
    stack.simulation.settings.gravity = {};
    for (Vec4& v : stack.cloths[1]->state.velocities.span()) v = {0.1f, -1, 0, 0};
    const auto momentum = [&] {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const Cloth* cloth : stack.cloths)
            for (std::uint32_t i = 0; i < cloth->state.size(); ++i)
                sum += (cloth->mass(i) * xyz(cloth->state.velocities[i])).cast<double>();
        return sum;
    };
    const Eigen::Vector3d before = momentum();
    for (Cloth* cloth : stack.cloths) {
        ClothSettings still = cloth->settings;
        still.air_damping = 0;
        still.method = Xpbd{};  // which keeps momentum by itself
        cloth->apply(still);
    }
    for (int k = 0; k < 30; ++k) stack.simulation.step(1.0f / 60);
    EXPECT_GT(stack.stand_in->meetings, 0);
    EXPECT_LT((momentum() - before).norm(), 1e-4 * before.norm());
    EXPECT_LT(stack.cloths[0]->state.velocities[70].y, -0.1f) << "the one that was hit moves";
}

TEST(Meeting, GivesTheSameBytesOnAnyThreads) {
    const auto after = [](int threads) {
        Stack stack(5, threads);
        stack.hold_lowest();
        for (int k = 0; k < 40; ++k) stack.simulation.step(1.0f / 60);
        return stack.positions();
    };
    const std::vector<Vec4> expected = after(1);
    for (const int threads : {2, 3, 4}) EXPECT_TRUE(same_bytes(after(threads), expected)) << threads;
}

TEST(Meeting, ClothsFarFromEachOtherAreIslandsOfTheirOwn) {
    Stack with(3, 2), without(3, 2, false);
    for (int k = 0; k < 20; ++k) {  // all fall alike
        with.simulation.step(1.0f / 60);
        without.simulation.step(1.0f / 60);
    }
    EXPECT_EQ(with.stand_in->meetings, 0);
    EXPECT_TRUE(same_bytes(with.positions(), without.positions()));
}

TEST(Meeting, ClothsOfLayersThatDoNotTouchAreIslandsOfTheirOwn) {
    Stack stack(2, 1);
    stack.stand_in->layers_touch = false;
    stack.hold_lowest();
    for (int k = 0; k < 60; ++k) stack.simulation.step(1.0f / 60);
    EXPECT_EQ(stack.stand_in->meetings, 0);
    EXPECT_LT(mean_height(*stack.cloths[1]), -1);
}

TEST(Meeting, TakesAllThatTouchTogetherOnceASubstep) {
    Stack stack(3, 2);
    stack.simulation.settings.gravity = {};
    for (Cloth* cloth : stack.cloths)
        for (Vec4& x : cloth->state.positions.span()) x.y *= 0.2f;  // 4 cm apart
    stack.simulation.step(1.0f / 60);
    EXPECT_EQ(stack.stand_in->meetings, stack.simulation.settings.substeps);
    EXPECT_EQ(stack.stand_in->cloths, 3 * stack.simulation.settings.substeps);
}

}  // namespace
}  // namespace weft::test
