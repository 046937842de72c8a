// Time shared out among cloths, and what is learnt of their costs.

#include "cloth/budget/allotment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "cloth/budget/budgeted.h"

namespace weft::test {
namespace {

Claim claim_of(float cost, float importance = 1, std::uint32_t rung = 0) {
    Claim claim{.importance = importance, .rung = rung};
    for (std::uint32_t r = 0; r < rung_count; ++r) claim.costs[r] = cost * ladder[r].cost;
    return claim;
}

Allotment allotment_of(const std::vector<Claim>& claims) {
    Allotment allotment;
    allotment.reserve(claims.size());
    allotment.claims() = claims;
    return allotment;
}

std::vector<Claim> random_claims(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0, 1);
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    std::vector<Claim> claims;
    for (int k = 0; k < 30; ++k) {
        Claim claim = claim_of(10 + 90 * unit(random), 0.1f + unit(random), below(rung_count));
        for (float& cost : claim.costs) cost *= 0.9f + 0.2f * unit(random);
        claim.first = below(rung_count);
        claim.last = claim.first + below(rung_count - claim.first);
        claims.push_back(claim);
    }
    return claims;
}

TEST(Allotment, SpendsWhatItsRungsCostAndNoMoreThanThereIs) {
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        const std::vector<Claim> claims = random_claims(seed);
        float least = 0;
        for (const Claim& claim : claims) least += claim.costs[claim.last];
        for (const float time : {0.5f * least, 1.1f * least, 1.5f * least, 3 * least}) {
            Allotment allotment = allotment_of(claims);
            allotment.allot(time);
            float spent = 0;
            for (std::size_t k = 0; k < claims.size(); ++k) {
                const Claim& claim = allotment.claims()[k];
                ASSERT_GE(claim.rung, claim.first);
                ASSERT_LE(claim.rung, claim.last);
                spent += claim.costs[claim.rung];
            }
            EXPECT_LE(spent, 1.0001f * std::max(time, least));
            EXPECT_NEAR(allotment.spent(), spent, 1e-2f * spent) << "dearer rungs that cost less apart";
        }
    }
}

TEST(Allotment, GivesAllWhereThereIsRoomForAll) {
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        std::vector<Claim> claims = random_claims(seed);
        for (Claim& claim : claims) claim.costs = claim_of(claim.costs[0]).costs;
        Allotment allotment = allotment_of(claims);
        allotment.allot(1e6f);
        for (const Claim& claim : allotment.claims()) EXPECT_EQ(claim.rung, claim.first);
    }
}

// The second step takes more error away for its time than the first, without which it cannot be had.
TEST(Allotment, BuysNoRungBeforeTheOneBelowIt) {
    Claim steep = claim_of(100);
    steep.rung = 2;
    steep.costs = {100, 99, 10};
    Allotment allotment = allotment_of({steep});
    allotment.allot(1e6f);
    EXPECT_EQ(allotment.claims()[0].rung, 0u);
    EXPECT_FLOAT_EQ(allotment.spent(), 100);
    allotment.claims()[0].rung = 2;
    allotment.allot(108);  // of which a reserve of a tenth is left
    EXPECT_EQ(allotment.claims()[0].rung, 2u);
    allotment.allot(110.5f);
    EXPECT_EQ(allotment.claims()[0].rung, 1u);
}

TEST(Allotment, WhatOneHasItKeepsAgainstItsEqual) {
    for (const std::size_t owner : {0u, 1u}) {
        std::vector<Claim> claims{claim_of(100, 1, 1), claim_of(100, 1, 1)};
        for (Claim& claim : claims) claim.last = 1;
        claims[owner].rung = 0;
        Allotment allotment = allotment_of(claims);
        allotment.allot(198);  // with its reserve, room for one
        EXPECT_EQ(allotment.claims()[owner].rung, 0u);
        EXPECT_EQ(allotment.claims()[1 - owner].rung, 1u);
    }
}

TEST(Allotment, WhatOneHasNotItGetsOnlyWhereSomeIsLeft) {
    for (const bool has_it : {false, true}) {
        Allotment allotment = allotment_of({claim_of(100, 1, has_it ? 0 : 4)});
        allotment.allot(105);
        EXPECT_EQ(allotment.claims()[0].rung == 0, has_it);
        allotment.allot(112);
        EXPECT_EQ(allotment.claims()[0].rung, 0u);
    }
}

TEST(RungCosts, AreGuessedFromTheOneThatIsKnown) {
    RungCosts costs(1000);
    for (std::uint32_t r = 0; r < rung_count; ++r) EXPECT_FLOAT_EQ(costs.all()[r], 1000 * ladder[r].cost);
    costs.add(2, 290);
    for (std::uint32_t r = 0; r < rung_count; ++r)
        EXPECT_FLOAT_EQ(costs.all()[r], 290 * ladder[r].cost / ladder[2].cost);
}

// A step that the machine stopped for a second says that it took twice as long.
TEST(RungCosts, ASurpriseCountsTwofoldAtMost) {
    RungCosts costs(1000);
    costs.add(0, 1000);
    costs.add(0, 1e9f);
    EXPECT_FLOAT_EQ(costs.all()[0], 1125);
    costs.add(0, 0);
    EXPECT_FLOAT_EQ(costs.all()[0], 1125 * (1 - 0.125f / 2));
}

TEST(RungCosts, OfAllRungsFollowTheClothOnceItsOwnIsLearnt) {
    RungCosts costs(1000);
    costs.add(1, 700);
    costs.change_rung();
    for (int k = 0; k < 8; ++k) costs.add(0, 1000);
    EXPECT_FLOAT_EQ(costs.all()[1], 700) << "the new rung is learnt";
    for (int k = 0; k < 100; ++k) costs.add(0, 2000);
    EXPECT_NEAR(costs.all()[0], 2000, 1);
    EXPECT_NEAR(costs.all()[1], 1400, 1);
    costs.change_rung();
    costs.add(1, 700);
    EXPECT_NEAR(costs.all()[0], 2000, 1);
}

TEST(Headroom, LeavesTimeForNineteenStepsOfTwenty) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> ratio(1, 1.4f);
    Headroom headroom;
    for (int k = 0; k < 20000; ++k) headroom.add(ratio(random));
    EXPECT_NEAR(1 / headroom.within(1), 1.38f, 0.04f);
    for (int k = 0; k < 2000; ++k) headroom.add(1000);
    EXPECT_FLOAT_EQ(headroom.within(3), 2) << "a machine that always stops is no reason to do nothing";
}

}  // namespace
}  // namespace weft::test
