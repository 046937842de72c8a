// ClothInfo::bytes is what a cloth takes, and a host can ask for it beforehand.

#include <gtest/gtest.h>
#include <malloc.h>

#include "tests/guarantees/allocation_count.h"
#include "tests/guarantees/method_cases.h"

namespace weft::test {
namespace {

class Memory : public testing::TestWithParam<MethodCase> {
  protected:
    static constexpr std::uint32_t side = 72;

    // Large buffers in pages of their own would be counted as whole pages.
    static void SetUpTestSuite() { mallopt(M_MMAP_THRESHOLD, 1 << 30); }
};

TEST_P(Memory, IsWhatTheClothSaysAndAsMeasuredBefore) {
    WorldSettings settings = GetParam().world;
    settings.threads = 1;
    World world = World::create(settings).value();
    const Mesh mesh = LoweredSheet::mesh(GetParam().grid, side);

    const std::int64_t before = allocated_bytes();
    const ClothInfo measured = world.measure_cloth(mesh, GetParam().cloth).value();
    EXPECT_EQ(allocated_bytes(), before) << "measuring leaves nothing behind";

    const ClothId cloth = world.add_cloth(mesh, GetParam().cloth).value();
    const auto taken = [&] { return static_cast<double>(allocated_bytes() - before); };
    const auto said = [&] { return static_cast<double>(world.cloth_info(cloth).value().bytes); };
    EXPECT_NEAR(said() / taken(), 1, 0.01) << said() << " of " << taken() << " bytes";
    EXPECT_EQ(world.cloth_info(cloth).value(), measured);

    ASSERT_TRUE(world.pin(cloth, 0));
    ASSERT_TRUE(world.pin(cloth, side - 1));
    for (int step = 0; step < 3; ++step) world.step(1.0f / 60.0f);
    EXPECT_NEAR(said() / taken(), 1, 0.01) << said() << " of " << taken() << " bytes, after three steps";
}

INSTANTIATE_TEST_SUITE_P(Methods, Memory, testing::ValuesIn(method_cases()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace weft::test
