// The bytes of a CookedCloth: what is damaged is refused, and what was changed, checksum and all, does no
// harm.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "tests/cooked_seal.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

std::vector<std::byte> saved_mesh(const ClothSettings& settings = {}) {
    Mesh mesh = make_sheet({.rows = 4, .columns = 5}).value();
    mesh.rows = mesh.columns = 0;
    const CookedCloth cooked = CookedCloth::create(mesh, settings).value();
    std::vector<std::byte> bytes(cooked.save_size());
    EXPECT_TRUE(cooked.save(bytes));
    return bytes;
}

TEST(CookedCloth, IsRefusedIfAnyByteIsCutOffOrAnother) {
    const std::vector<std::byte> whole = saved_mesh();
    ASSERT_TRUE(CookedCloth::load(whole));
    for (std::size_t size = 0; size < whole.size(); ++size)
        ASSERT_FALSE(CookedCloth::load(std::span(whole).first(size))) << size << " bytes";
    std::vector<std::byte> longer = whole;
    longer.push_back({});
    EXPECT_FALSE(CookedCloth::load(longer));
    for (std::size_t at = 0; at < whole.size(); ++at) {
        for (const unsigned flip : {1u, 128u, 255u}) {
            std::vector<std::byte> other = whole;
            other[at] ^= static_cast<std::byte>(flip);
            const auto loaded = CookedCloth::load(other);
            ASSERT_FALSE(loaded) << "byte " << at;
            ASSERT_EQ(loaded.error().code, ErrorCode::malformed_file);
        }
    }
}

// What names what is not there, though nothing says that it is damaged.
class AlteredCookedCloth : public testing::TestWithParam<SelfCollision> {};

constexpr SelfCollision off{}, contact{.method = SelfCollisionMethod::contact},
    avoidance{.method = SelfCollisionMethod::avoidance};
constexpr std::array<const char*, 3> names = {"Off", "Contact", "Avoidance"};

INSTANTIATE_TEST_SUITE_P(All, AlteredCookedCloth, testing::Values(off, contact, avoidance),
                         [](const auto& info) { return names[info.index]; });

TEST_P(AlteredCookedCloth, NamesNothingThatIsNotThere) {
    const ClothSettings settings{.self_collision = GetParam()};
    const std::vector<std::byte> whole = saved_mesh(settings);
    std::vector<std::byte> sealed = whole;
    seal_cooked(sealed);
    ASSERT_EQ(sealed, whole) << "the test seals as saving does";
    World world = World::create({.threads = 1}).value();
    int refused = 0, tried = 0;
    for (const std::uint32_t value : {0xfffffff0u, 20u, 1u << 31}) {
        for (std::size_t at = 12; at + 4 <= whole.size(); at += 4) {
            if (at >= 48 && at < 64) continue;  // the size and the sum
            std::vector<std::byte> other = whole;
            std::memcpy(other.data() + at, &value, 4);
            seal_cooked(other);
            ++tried;
            const auto loaded = CookedCloth::load(other, settings);
            if (!loaded) ++refused;
            if (!loaded || tried % 5 != 0) continue;
            // What is taken may move as it likes, but reads and writes its own memory alone.
            const auto cloth = world.add_cloth(*loaded);
            if (!cloth) continue;
            if (world.pin(*cloth, 7)) world.step(1.0f / 60);
            ASSERT_TRUE(world.remove_cloth(*cloth));
        }
    }
    EXPECT_GT(refused, tried / 5);  // most of it are numbers, which may be any
}

TEST(CookedCloth, WhatItSaysOfTheMeshHasToBeSo) {
    const std::vector<std::byte> whole = saved_mesh();
    constexpr std::size_t info = cooked_head + 64;  // behind how many there are
    const auto loads_with = [&](std::size_t offset, auto value) {
        std::vector<std::byte> other = whole;
        std::memcpy(other.data() + info + offset, &value, sizeof value);
        seal_cooked(other);
        return CookedCloth::load(other).ok();
    };
    const ClothInfo said = CookedCloth::load(whole)->info();
    ASSERT_TRUE(loads_with(offsetof(ClothInfo, mean_edge), said.mean_edge));
    for (const float edge : {NAN, INFINITY, -1.0f, 1e30f})
        EXPECT_FALSE(loads_with(offsetof(ClothInfo, mean_edge), edge)) << edge;
    ASSERT_TRUE(loads_with(offsetof(ClothInfo, particles), said.particles));
    for (const std::size_t count : {offsetof(ClothInfo, vertices), offsetof(ClothInfo, particles),
                                    offsetof(ClothInfo, triangles), offsetof(ClothInfo, components)})
        EXPECT_FALSE(loads_with(count, 7u)) << count;
}

TEST(CookedCloth, SaysWhyItRefuses) {
    std::vector<std::byte> bytes = saved_mesh();
    const auto message = [&] { return CookedCloth::load(bytes).error().message; };
    bytes[8] = std::byte{99};
    EXPECT_NE(message().find("version 99"), std::string::npos) << message();
    bytes[0] = std::byte{'X'};
    EXPECT_NE(message().find("WEFTCOOK"), std::string::npos) << message();
    bytes.resize(4);
    EXPECT_NE(message().find("cut short"), std::string::npos) << message();

    const CookedCloth cooked = CookedCloth::create(make_sheet().value()).value();
    std::vector<std::byte> small(cooked.save_size() - 1);
    EXPECT_FALSE(cooked.save(small));
}

}  // namespace
}  // namespace weft::test
