// Cooking that tells how far it is, and can be cancelled.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "weft/weft.h"

namespace weft::test::progress {
namespace {

/// What a host was told; cancels at the call of that number, from 0.
struct Told {
    std::vector<float> parts;
    std::size_t cancel_at = SIZE_MAX;

    [[nodiscard]] CookProgress callback() {
        return {.user = this, .report = [](void* user, float done) {
                    auto& told = *static_cast<Told*>(user);
                    told.parts.push_back(done);
                    return told.parts.size() - 1 != told.cancel_at;
                }};
    }
};

Mesh mesh_of(bool grid) {
    Mesh mesh = make_sheet({.rows = 12, .columns = 9}).value();
    if (!grid) mesh.rows = mesh.columns = 0;
    return mesh;
}

TEST(CookProgress, GrowsToOne) {
    for (const bool grid : {false, true}) {
        Told told;
        ASSERT_TRUE(CookedCloth::create(mesh_of(grid), {}, told.callback()));
        ASSERT_GE(told.parts.size(), 4u);
        EXPECT_GT(told.parts.front(), 0);
        EXPECT_TRUE(std::ranges::is_sorted(told.parts, std::less_equal<>())) << "each is more than the last";
        EXPECT_EQ(told.parts.back(), 1);
        EXPECT_EQ(std::ranges::count(told.parts, 1.0f), 1);
    }
}

TEST(CookProgress, CancelsAtEachCallButTheLast) {
    Told all;
    ASSERT_TRUE(CookedCloth::create(mesh_of(false), {}, all.callback()));
    for (std::size_t at = 0; at < all.parts.size(); ++at) {
        Told told{.parts = {}, .cancel_at = at};
        const auto cooked = CookedCloth::create(mesh_of(false), {}, told.callback());
        if (at + 1 == all.parts.size()) {
            EXPECT_TRUE(cooked);
            continue;
        }
        ASSERT_FALSE(cooked);
        EXPECT_EQ(cooked.error().code, ErrorCode::cancelled);
        EXPECT_EQ(told.parts.size(), at + 1) << "nothing is told any more";
    }
}

TEST(CookProgress, OfWhatCannotBeCookedDoesNotReachOne) {
    Told told;
    ClothSettings settings;
    settings.substeps = -1;
    EXPECT_FALSE(CookedCloth::create(mesh_of(true), settings, told.callback()));
    EXPECT_FALSE(CookedCloth::create(Mesh{}, {}, told.callback()));
    EXPECT_EQ(std::ranges::count(told.parts, 1.0f), 0);
}

TEST(CookProgress, ChangesNothingOfTheCloth) {
    Told told;
    const CookedCloth with = CookedCloth::create(mesh_of(false), {}, told.callback()).value(),
                      without = CookedCloth::create(mesh_of(false)).value();
    std::vector<std::byte> a(with.save_size()), b(without.save_size());
    ASSERT_TRUE(with.save(a));
    ASSERT_TRUE(without.save(b));
    EXPECT_EQ(a, b);
    EXPECT_EQ(with.info(), without.info());
}

}  // namespace
}  // namespace weft::test::progress
