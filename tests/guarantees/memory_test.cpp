// ClothInfo::bytes is what a cloth takes, and a host can ask for it beforehand.

#include <gtest/gtest.h>
#include <malloc.h>

#include <vector>

#include "tests/guarantees/allocation_count.h"
#include "tests/guarantees/method_cases.h"

namespace weft::test {
namespace {

/// `count` separate quads side by side.
Mesh quads(std::uint32_t count) {
    Mesh mesh;
    for (std::uint32_t k = 0; k < count; ++k) {
        const float x = 0.02f * static_cast<float>(k % 40), z = 0.02f * static_cast<float>(k / 40);
        const std::uint32_t v = 4 * k;
        for (const Vec3 corner :
             {Vec3{x, 1, z}, {x + 0.01f, 1, z}, {x, 1, z + 0.01f}, {x + 0.01f, 1, z + 0.01f}})
            mesh.positions.push_back(corner);
        mesh.triangles.push_back({v, v + 2, v + 1});
        mesh.triangles.push_back({v + 1, v + 2, v + 3});
    }
    return mesh;
}

/// A general mesh with as many particles of no triangle.
Mesh with_loose_particles(std::uint32_t side) {
    Mesh mesh = LoweredSheet::mesh(false, side);
    mesh.texcoords.clear();
    for (std::uint32_t k = 0; k < side * side; ++k)
        mesh.positions.push_back({0.01f * static_cast<float>(k), 2, 0});
    return mesh;
}

class Memory : public testing::TestWithParam<MethodCase> {
  protected:
    static constexpr std::uint32_t side = 72;

    // Large buffers in pages of their own would be counted as whole pages.
    static void SetUpTestSuite() {
#ifdef M_MMAP_THRESHOLD
        mallopt(M_MMAP_THRESHOLD, 1 << 30);
#endif
    }

    static void expect_as_said(const Mesh& mesh, double tolerance, const std::vector<std::uint32_t>& pins) {
        WorldSettings settings = GetParam().world;
        settings.threads = 1;
        World world = World::create(settings).value();

        const std::int64_t before = allocated_bytes();
        const auto measured_or = world.measure_cloth(mesh, GetParam().cloth);
        ASSERT_TRUE(measured_or) << measured_or.error().message;
        const ClothInfo measured = *measured_or;
        EXPECT_EQ(allocated_bytes(), before) << "measuring leaves nothing behind";

        const ClothId cloth = world.add_cloth(mesh, GetParam().cloth).value();
        const auto taken = [&] { return static_cast<double>(allocated_bytes() - before); };
        const auto said = [&] { return static_cast<double>(world.cloth_info(cloth).value().bytes); };
        EXPECT_NEAR(said() / taken(), 1, tolerance) << said() << " of " << taken() << " bytes";
        EXPECT_EQ(world.cloth_info(cloth).value(), measured);

        ASSERT_TRUE(world.pin(cloth, pins));
        // Short ones: what is taken does not depend on their length, what an explicit method costs does.
        for (int step = 0; step < 3; ++step) world.step(1.0f / 600);
        EXPECT_NEAR(said() / taken(), 1, tolerance)
            << said() << " of " << taken() << " bytes, after three steps";
    }
};

TEST_P(Memory, IsWhatTheClothSaysAndAsMeasuredBefore) {
    const Mesh sheet = LoweredSheet::mesh(GetParam().grid, side);
    for (const PinPattern& pins : pin_patterns(side)) {
        if (pins.name != "none" && pins.name != "random") continue;  // the least and the most
        SCOPED_TRACE(pins.name);
        expect_as_said(sheet, 0.01, pins.vertices);
    }
}

TEST_P(Memory, OfManyComponentsAndLooseParticlesIsWhatTheClothSays) {
    {
        SCOPED_TRACE("200 quads");
        expect_as_said(quads(200), 0.02, {0, 2, 402});
    }
    {
        SCOPED_TRACE("1300 quads");
        expect_as_said(quads(1300), 0.01, {0, 2, 402});
    }
    SCOPED_TRACE("loose particles");
    expect_as_said(with_loose_particles(side), 0.01, {0, side - 1});
}

INSTANTIATE_TEST_SUITE_P(Methods, Memory, testing::ValuesIn(method_cases()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace weft::test
