// Real garments, sewn from flat panels: NAME.obj has the pattern as texture coordinates, NAME-m.obj as a mesh
// with the same faces in the same order.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "cloth/mesh/cook.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"
#include "weft/mesh.h"

namespace weft {
namespace {

struct Garment {
    const char* name;
    std::uint32_t file_vertices, file_faces, panel_vertices;
};

void PrintTo(const Garment& garment, std::ostream* out) {
    *out << garment.name;
}

class Garments : public testing::TestWithParam<Garment> {
  protected:
    void SetUp() override {
        const char* data = std::getenv("WEFT_DATA");
        if (data == nullptr)
            GTEST_SKIP() << "set WEFT_DATA to the folder of test data, which has garments/*.obj";
        folder_ = std::filesystem::path(data) / "garments";
    }

    [[nodiscard]] std::filesystem::path file(const char* suffix = "") const {
        return folder_ / (std::string(GetParam().name) + suffix + ".obj");
    }

    std::filesystem::path folder_;
};

/// Those that have a -m mesh.
class GarmentsWithPattern : public Garments {};

using Pair = std::pair<std::uint32_t, std::uint32_t>;

std::map<Pair, float> structural_lengths(const ClothModel& cloth) {
    std::map<Pair, float> lengths;
    for (std::uint32_t i = 0; i < cloth.particle_count; ++i)
        for (std::uint32_t e = cloth.spring_offsets[i]; e < cloth.spring_offsets[i + 1]; ++e)
            if (cloth.kinds[e] == SpringKind::structural && i < cloth.neighbours[e])
                lengths[{i, cloth.neighbours[e]}] = cloth.rest_lengths[e];
    return lengths;
}

TEST_P(Garments, LoadsAndWeldsToTheFilesVertices) {
    ObjReport report;
    const Result<Mesh> mesh = load_obj(file(), {.texcoords_are_pattern = true}, &report);
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->positions.size(), GetParam().panel_vertices);
    EXPECT_EQ(report.ignored_lines, GetParam().file_vertices + GetParam().file_faces);  // vv, t
    EXPECT_EQ(report.triangulated_faces, 0u);

    const Result<ClothModel> cloth = cook(*mesh);
    ASSERT_TRUE(cloth) << cloth.error().message;
    EXPECT_EQ(cloth->info.particles, GetParam().file_vertices);
    EXPECT_EQ(cloth->info.triangles, GetParam().file_faces);
    EXPECT_EQ(cloth->info.components, 1u);
    EXPECT_EQ(cloth->info.dropped_triangles, 0u);
    EXPECT_EQ(cloth->info.misoriented_edges, 0u);
    EXPECT_EQ(cloth->info.loose_particles, 0u);
    std::vector<std::uint32_t> particles(cloth->vertex_to_particle.begin(),
                                         cloth->vertex_to_particle.begin() + GetParam().file_vertices);
    std::ranges::sort(particles);
    for (std::uint32_t i = 0; i < particles.size(); ++i) ASSERT_EQ(particles[i], i) << "each particle once";
    for (const float length : cloth->rest_lengths.span()) ASSERT_TRUE(std::isfinite(length) && length > 0);
}

TEST_P(GarmentsWithPattern, RestShapeIsTheFlatPattern) {
    const Mesh mesh = test::must(load_obj(file(), {.texcoords_are_pattern = true}));
    const ClothModel sewn = test::must(cook(mesh));
    const ClothModel flat = test::must(cook(test::must(load_obj(file("-m")))));
    ASSERT_EQ(sewn.triangles.size(), flat.triangles.size());
    EXPECT_NEAR(test::total_rest_area(sewn), test::total_rest_area(flat), 1e-6 * test::total_rest_area(flat));

    // Sewing maps each of the pattern's edges to one of the garment's; a seam has two.
    const std::map<Pair, float> sewn_lengths = structural_lengths(sewn),
                                flat_lengths = structural_lengths(flat);
    std::map<Pair, std::map<Pair, float>> panels_of;
    for (std::size_t t = 0; t < sewn.triangles.size(); ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto side = [&](const Triangle& triangle) -> Pair {
                return std::minmax({triangle[corner], triangle[(corner + 1) % 3]});
            };
            const Pair panel_edge = side(flat.triangles[t]);
            panels_of[side(sewn.triangles[t])][panel_edge] = flat_lengths.at(panel_edge);
        }
    }
    ASSERT_EQ(panels_of.size(), sewn_lengths.size());
    std::size_t seams = 0;
    for (const auto& [edge, panels] : panels_of) {
        double mean = 0;
        for (const auto& [panel_edge, length] : panels)
            mean += static_cast<double>(length) / static_cast<double>(panels.size());
        seams += panels.size() > 1;
        ASSERT_NEAR(sewn_lengths.at(edge), mean, 1e-6 * mean) << edge.first << " - " << edge.second;
    }
    EXPECT_EQ(flat_lengths.size(), sewn_lengths.size() + seams);
    EXPECT_GT(seams, 0u);
}

TEST_P(Garments, RoundTrip) {
    const Mesh expected = test::must(load_obj(file(), {.texcoords_are_pattern = true}));
    const auto copy =
        std::filesystem::path(testing::TempDir()) / ("weft_copy_of_" + std::string(GetParam().name) + ".obj");
    ASSERT_TRUE(save_obj(copy, expected));
    const Mesh mesh = test::must(load_obj(copy, {.texcoords_are_pattern = true}));
    std::filesystem::remove(copy);
    EXPECT_EQ(mesh.triangles, expected.triangles);
    ASSERT_EQ(mesh.positions.size(), expected.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 &p = mesh.positions[i], &q = expected.positions[i];
        ASSERT_TRUE(p.x == q.x && p.y == q.y && p.z == q.z) << i;
        ASSERT_TRUE(mesh.pattern[i].x == expected.pattern[i].x && mesh.pattern[i].y == expected.pattern[i].y)
            << i;
    }
}

constexpr Garment skirt{"skirt-iso", 2594, 4996, 2782}, tshirt{"tshirt-iso", 3546, 6954, 3775},
    dress{"dress-victor-iso-draped", 4589, 8958, 4636}, coarse_skirt{"skirt-coarse", 127, 207, 177};

std::string test_name(const testing::TestParamInfo<Garment>& info) {
    std::string name = info.param.name;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Berkeley, Garments, testing::Values(skirt, tshirt, dress, coarse_skirt), test_name);
INSTANTIATE_TEST_SUITE_P(Berkeley, GarmentsWithPattern, testing::Values(skirt, tshirt, dress), test_name);

}  // namespace
}  // namespace weft
