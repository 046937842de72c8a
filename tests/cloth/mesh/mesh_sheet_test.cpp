#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>

#include "engine/vector.h"
#include "tests/cloth/meshes.h"
#include "weft/mesh.h"

namespace weft {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

Vector3 normal(const Mesh& mesh, const Triangle& triangle) {
    const Vector3 a = to_vector(mesh.positions[triangle[0]]);
    return (to_vector(mesh.positions[triangle[1]]) - a).cross(to_vector(mesh.positions[triangle[2]]) - a);
}

TEST(MakeSheet, LaysVerticesOutRowByRowBetweenExactCorners) {
    const Mesh sheet = test::must(
        make_sheet({.rows = 4, .columns = 7, .origin = {1, 2, 3}, .u = {0, 0, 3}, .v = {0, 6, 0}}));
    ASSERT_EQ(sheet.positions.size(), 28u);
    EXPECT_EQ(sheet.rows, 4u);
    EXPECT_EQ(sheet.columns, 7u);
    for (std::uint32_t row = 0; row < 4; ++row) {
        for (std::uint32_t column = 0; column < 7; ++column) {
            const Vector3 expected(1, 2 + 2 * static_cast<float>(row), 3 + 0.5f * static_cast<float>(column));
            EXPECT_TRUE(to_vector(sheet.positions[row * 7 + column]).isApprox(expected, 1e-6f));
        }
    }
    EXPECT_EQ(to_vector(sheet.positions.back()), Vector3(1, 8, 6));
}

TEST(MakeSheet, FacesTheSideOfVCrossU) {
    const Mesh level = test::must(make_sheet({.rows = 5, .columns = 4}));
    for (const Triangle& triangle : level.triangles) EXPECT_GT(normal(level, triangle).y(), 0);

    const SheetSettings tilted{.rows = 5, .columns = 4, .u = {1, 0.5f, 0}, .v = {0.2f, -1, 3}};
    const Mesh sheet = test::must(make_sheet(tilted));
    const Vector3 front = to_vector(tilted.v).cross(to_vector(tilted.u));
    for (const Triangle& triangle : sheet.triangles) EXPECT_GT(normal(sheet, triangle).dot(front), 0);
}

TEST(MakeSheet, TrianglesCoverItOnceWithAlternatingDiagonals) {
    const Mesh sheet = test::must(make_sheet({.rows = 6, .columns = 9, .u = {2, 0, 0}, .v = {0, 0, 3}}));
    EXPECT_EQ(sheet.triangles.size(), 2u * 5 * 8);
    float area = 0;
    for (const Triangle& triangle : sheet.triangles) area += 0.5f * normal(sheet, triangle).norm();
    EXPECT_NEAR(area, 6, 1e-4);

    // A vertex inside has all four diagonals or none: eight triangles or four.
    std::vector<int> triangles_at(sheet.positions.size());
    for (const Triangle& triangle : sheet.triangles)
        for (const std::uint32_t vertex : triangle) ++triangles_at[vertex];
    for (std::uint32_t row = 1; row + 1 < 6; ++row)
        for (std::uint32_t column = 1; column + 1 < 9; ++column)
            EXPECT_EQ(triangles_at[row * 9 + column], (row + column) % 2 == 0 ? 8 : 4);
}

TEST(MakeSheet, TextureCoordinatesAreMetresAlongUAndV) {
    const Mesh sheet = test::must(make_sheet({.rows = 3, .columns = 5, .u = {3, 4, 0}, .v = {0, 0, -2}}));
    EXPECT_EQ(sheet.texcoords.size(), 15u);
    EXPECT_EQ(sheet.texcoords[0].x, 0);
    EXPECT_EQ(sheet.texcoords[4].x, 5);
    EXPECT_EQ(sheet.texcoords[4].y, 0);
    EXPECT_EQ(sheet.texcoords[14].x, 5);
    EXPECT_EQ(sheet.texcoords[14].y, 2);
    EXPECT_TRUE(sheet.pattern.empty());
}

TEST(MakeSheet, RefusesWhatIsOutOfRangeByName) {
    const struct {
        SheetSettings settings;
        const char *name, *value;
    } cases[] = {
        {{.rows = 1}, "rows", "1"},
        {{.columns = 0}, "columns", "0"},
        {{.rows = 65536, .columns = 2048}, "rows * SheetSettings::columns", "134217728"},
        {{.rows = ~0u, .columns = ~0u}, "rows * SheetSettings::columns", "67108864"},
        {{.origin = {0, infinity, 0}}, "origin", "inf"},
        {{.u = {infinity, 0, 0}}, "SheetSettings::u", "inf"},
        {{.v = {0, 0, -infinity}}, "SheetSettings::v", "-inf"},
        {{.u = {0, 0, 0}}, "SheetSettings::u", "(0, 0, 0)"},
        {{.v = {0, 0, 0}}, "SheetSettings::v", "(0, 0, 0)"},
        {{.v = {-2, 0, 0}}, "parallel", "(-2, 0, 0)"},
        {{.origin = {3e38f, 0, 0}, .u = {3e38f, 0, 0}}, "origin + u + v", "inf"},
    };
    for (const auto& [settings, name, value] : cases) {
        const Result<Mesh> sheet = make_sheet(settings);
        ASSERT_FALSE(sheet) << name;
        EXPECT_EQ(sheet.error().code, ErrorCode::invalid_argument);
        EXPECT_NE(sheet.error().message.find(name), std::string::npos) << sheet.error().message;
        EXPECT_NE(sheet.error().message.find(value), std::string::npos) << sheet.error().message;
    }
}

}  // namespace
}  // namespace weft
