#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>

#include "cloth/mesh/cook.h"
#include "engine/vector.h"
#include "tests/cloth/meshes.h"
#include "weft/mesh.h"
#include "weft/world.h"

namespace weft {
namespace {

/// A file that lasts as long as the test, in a folder of the test's own.
class ObjFile : public testing::Test {
  protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(testing::TempDir()) / (std::string("weft_") + info->name());
        std::filesystem::create_directories(folder_);
        file_ = folder_ / "cloth.obj";
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    void write(std::string_view text) const { std::ofstream(file_, std::ios::binary) << text; }

    Result<Mesh> load(std::string_view text, const ObjOptions& options = {},
                      ObjReport* report = nullptr) const {
        write(text);
        return load_obj(file_, options, report);
    }

    /// The load must fail, with a message that has all these parts.
    void expect_error(std::string_view text, std::initializer_list<const char*> parts,
                      const ObjOptions& options = {}) const {
        const Result<Mesh> mesh = load(text, options);
        ASSERT_FALSE(mesh) << text;
        EXPECT_EQ(mesh.error().code, ErrorCode::malformed_file);
        EXPECT_NE(mesh.error().message.find("cloth.obj:"), std::string::npos) << mesh.error().message;
        for (const char* part : parts)
            EXPECT_NE(mesh.error().message.find(part), std::string::npos)
                << '"' << part << "\" in: " << mesh.error().message;
    }

    std::filesystem::path folder_, file_;
};

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

constexpr const char* square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(ObjFile, ReadsTriangles) {
    const Mesh mesh = test::must(load(std::string(square) + "f 1 2 3\nf 1 3 4\n"));
    ASSERT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.positions[2].x, 1);
    EXPECT_EQ(mesh.positions[2].y, 1);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_TRUE(mesh.texcoords.empty());
    EXPECT_TRUE(mesh.pattern.empty());
    EXPECT_EQ(mesh.rows, 0u);
}

TEST_F(ObjFile, CutsFacesIntoFansAndCountsThem) {
    ObjReport report;
    const Mesh mesh =
        test::must(load(std::string(square) + "v 0 2 0\nf 1 2 3 4\nf 4 3 5\nf 1 2 3 5 4\n", {}, &report));
    EXPECT_EQ(mesh.triangles,
              (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {0, 1, 2}, {0, 2, 4}, {0, 4, 3}}));
    EXPECT_EQ(report.triangulated_faces, 2u);
    EXPECT_EQ(report.ignored_lines, 0u);
}

double area_of(const Mesh& mesh) {
    double sum = 0;
    for (const auto [a, b, c] : mesh.triangles) {
        const Vector3 p = to_vector(mesh.positions[a]);
        const Vector3 u = to_vector(mesh.positions[b]) - p, v = to_vector(mesh.positions[c]) - p;
        sum += 0.5 * static_cast<double>(u.cross(v).norm());
    }
    return sum;
}

constexpr const char* letter_c = "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 2 0\nv 3 2 0\nv 3 3 0\nv 0 3 0\n";

TEST_F(ObjFile, ConcaveFacesKeepTheirAreaAndTheirSide) {
    for (const char* face : {"f 2 3 4 5 6 7 8 1\n", "f 1 2 3 4 5 6 7 8\n", "f 8 7 6 5 4 3 2 1\n"}) {
        for (const std::string& text : {std::string(letter_c) + face, face + std::string(letter_c)}) {
            ObjReport report;
            const Mesh mesh = test::must(load(text, {}, &report));
            EXPECT_EQ(mesh.triangles.size(), 6u);
            EXPECT_NEAR(area_of(mesh), 7, 1e-6) << text;
            EXPECT_EQ(report.triangulated_faces, 1u);
            EXPECT_EQ(report.crossing_faces, 0u);
            EXPECT_EQ(report.touching_faces, 0u);
            for (const auto [a, b, c] : mesh.triangles) {
                const Vector3 p = to_vector(mesh.positions[a]);
                const Vector3 u = to_vector(mesh.positions[b]) - p, v = to_vector(mesh.positions[c]) - p;
                EXPECT_EQ(u.cross(v).z() > 0, face[2] != '8');
            }
        }
    }
}

TEST_F(ObjFile, CornersOfConcaveFacesKeepTheirTextureCoordinates) {
    std::string text = letter_c, face = "f";
    for (int i = 1; i <= 8; ++i) {
        text.append("vt ").append(std::to_string(i)).append(" 5\n");
        face.append(" ").append(std::to_string(i)).append("/").append(std::to_string(9 - i));
    }
    const Mesh mesh = test::must(load(text + face + "\n"));
    ASSERT_EQ(mesh.positions.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(mesh.texcoords[i].x, static_cast<float>(8 - i));
}

TEST_F(ObjFile, FacesWithHolesAreCutAndCounted) {
    ObjReport report;
    const std::string frame = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\n";
    const Mesh mesh = test::must(load(frame + "f 1 2 3 4 1 5 6 7 8 5\nf 1 2 3\nf 1 2 3 4\n", {}, &report));
    EXPECT_EQ(mesh.triangles.size(), 8u + 1 + 2);
    EXPECT_NEAR(area_of(mesh), 8 + 4.5 + 9, 1e-5);
    EXPECT_EQ(report.triangulated_faces, 2u);
    EXPECT_EQ(report.touching_faces, 1u);
    EXPECT_EQ(report.crossing_faces, 0u);

    World world = test::must(World::create({.threads = 1}));
    const Mesh alone = test::must(load(frame + "f 1 2 3 4 1 5 6 7 8 5\n"));
    const ClothInfo info = test::must(world.cloth_info(test::must(world.add_cloth(alone))));
    EXPECT_EQ(info.particles, 8u);
    EXPECT_EQ(info.border_edges, 8u);
    EXPECT_EQ(info.dropped_triangles, 0u);
}

TEST_F(ObjFile, OutlinesThatCrossThemselvesAreCounted) {
    ObjReport report;
    const Mesh mesh =
        test::must(load(std::string(square) + "f 1 3 2 4\nf 1 2 3 4\nf 4 2 3 1\n", {}, &report));
    EXPECT_EQ(mesh.triangles.size(), 6u);
    EXPECT_EQ(report.triangulated_faces, 3u);
    EXPECT_EQ(report.crossing_faces, 2u);
    EXPECT_EQ(report.touching_faces, 0u);
}

TEST_F(ObjFile, ToleratesAndCountsLinesOfOtherKinds) {
    ObjReport report;
    const Mesh mesh =
        test::must(load("# a comment\n\n   \nmtllib none.mtl\no thing\nv 0 0 0\nvv 0 0 0\nv 1 0 0 # "
                        "here\nvn 0 0 1\nv 0 1 0\n"
                        "g a b\nusemtl x\ns off\nf 1//1 2//1 3//1\nt 0 1 2\nl 1 2\n",
                        {}, &report));
    EXPECT_EQ(mesh.triangles.size(), 1u);
    EXPECT_EQ(report.ignored_lines, 9u);
}

TEST_F(ObjFile, ReadsEveryFormOfCorner) {
    const std::string head = std::string(square) + "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n";
    for (const char* face :
         {"f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/3/1", "f -4 -3 -2",
          "f -4/-3 -3/-2 -2/-1", " \tf  1\t2  3  ", "f -4/-3/-1 2/2/1 3/3/1"}) {
        const Mesh mesh = test::must(load(head + face + "\n"));
        EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}})) << face;
        EXPECT_EQ(mesh.texcoords.empty(),
                  std::strchr(face, '/') == nullptr || std::strstr(face, "//") != nullptr);
    }
}

TEST_F(ObjFile, NegativeIndicesCountBackFromTheirLine) {
    const Mesh mesh =
        test::must(load("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 5 0 0\nv 6 0 0\nv 6 1 0\nf -3 -2 -1\n"));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}}));
}

TEST_F(ObjFile, FacesMayComeBeforeTheirVertices) {
    EXPECT_EQ(test::must(load("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 1 1 0\n")).triangles,
              (std::vector<Triangle>{{0, 1, 2}}));
}

TEST_F(ObjFile, LineEndingsContinuationsAndByteOrderMarksMakeNoDifference) {
    const Mesh expected = test::must(load(std::string(square) + "f 1 2 3\nf 1 3 4"));
    for (const char* text : {
             "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3\r\nf 1 3 4\r\n",
             "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3\rf 1 3 4\r",
             "v 0 \\\n0 0\nv 1\\\r\n0 0\nv 1 1 0\nv 0 1 \\\n\\\n0\nf 1 2 3\nf 1 \\\n3 4",
             "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n",
             "v 0 0 0\n# from C:\\cloth\\\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n",
             "v +0 .0 0.\nv 1e0 0 0\nv 10e-1 0.1E1 0\nv 0 1 0 1 0.5 0.5\nf 1 2 3\nf 1 3 4\n",
         }) {
        const Result<Mesh> mesh = load(text);
        ASSERT_TRUE(mesh) << mesh.error().message;
        EXPECT_TRUE(same_bytes(mesh->positions, expected.positions)) << text;
        EXPECT_EQ(mesh->triangles, expected.triangles);
    }
}

TEST_F(ObjFile, KeepsTheFilesVertexNumbersAndAppendsSeamVertices) {
    // The edge 1-3 is a seam: its two vertices have other texture coordinates in the second face.
    const char* text =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\nvt 0 0\nvt 1 0\nvt 1 1\nvt 5 5\nvt 6 6\nvt 5 6\nvt 5 "
        "5\n"
        "f 1/1 2/2 3/3\nf 1/4 3/5 4/6\n";
    const Mesh mesh = test::must(load(text, {.texcoords_are_pattern = true}));
    ASSERT_EQ(mesh.positions.size(), 7u);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {5, 6, 3}}));
    EXPECT_EQ(mesh.positions[4].x, 9);
    EXPECT_EQ(mesh.positions[6].y, 1);
    EXPECT_EQ(mesh.pattern[5].x, 5);
    EXPECT_EQ(mesh.pattern[2].x, 1);
    EXPECT_TRUE(same_bytes(mesh.pattern, mesh.texcoords));
    EXPECT_TRUE(load(text)->pattern.empty());
}

TEST_F(ObjFile, EqualTextureCoordinatesShareAVertex) {
    const Mesh mesh = test::must(load(std::string(square) + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 0\nvt 1 1\nvt 0 1\n"
                                                            "f 1/1 2/2 3/3\nf 1/4 3/5 4/6\n"));
    EXPECT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(ObjFile, ErrorsNameFileLineAndValue) {
    const std::string head = square;
    expect_error("v 0 0 0\nv 1 nan 0\n", {"cloth.obj:2:", "coordinate 2", "\"nan\"", "finite"});
    expect_error("v 0 0 0\r\nv 1 0 -inf\r\n", {"cloth.obj:2:", "coordinate 3", "\"-inf\""});
    expect_error("v 0 0 1e39\n", {"cloth.obj:1:", "\"1e39\""});
    expect_error("v 0 0 1e999\n", {"cloth.obj:1:", "\"1e999\""});
    expect_error("v 0 0x1 2\n", {"cloth.obj:1:", "\"0x1\""});
    expect_error("\nv 0 1,5 2\n", {"cloth.obj:2:", "\"1,5\""});
    expect_error("v 0 +-1 2\n", {"\"+-1\""});
    expect_error("v 0 0 0\nv 1 0\n", {"cloth.obj:2:", "cut short", "2 coordinates", "needs 3"});
    expect_error("v", {"cloth.obj:1:", "0 coordinates"});
    expect_error("v 0 0 0\nvt 0.5\n", {"cloth.obj:2:", "cut short", "\"vt\"", "needs 2"});
    expect_error(head + "f 1 2 0\n", {"cloth.obj:5:", "\"0\"", "vertex index 0", "counted from 1"});
    expect_error(head + "f 1 2 5\n", {"cloth.obj:5:", "vertex index 5", "has 4"});
    expect_error("v 0 0 0\nf 1 -1 -2\nv 1 1 1\n", {"cloth.obj:2:", "vertex index -2", "has 1 before"});
    expect_error(head + "f 1 2 99999999999\n", {"cloth.obj:5:", "99999999999"});
    expect_error(head + "f 1 2 99999999999999999999\n",
                 {"cloth.obj:5:", "99999999999999999999", "whole number"});
    expect_error(head + "f 1 2 x\n", {"cloth.obj:5:", "\"x\"", "whole number"});
    expect_error(head + "f 1 2 3.5\n", {"\"3.5\""});
    expect_error(head + "f 1 2 3/\n", {"\"3/\""});
    expect_error(head + "f 1 2 3//\n", {"\"3//\""});
    expect_error(head + "f 1 2 3/x\n", {"\"3/x\""});
    expect_error(head + "f 1 2 3//x\n", {"\"3//x\""});
    expect_error(head + "vt 0 0\nf 1/1 2/1 3/2\n", {"cloth.obj:6:", "texture coordinate index 2", "has 1"});
    expect_error(head + "vt 0 0\nf 1/1 2/1 3/0\n", {"cloth.obj:6:", "texture coordinate index 0"});
    expect_error(head + "vt 0 0\nf 1/1/1/1 2/1 3/1\n", {"\"1/1/1/1\""});
    expect_error(head + "f 1 2\n", {"cloth.obj:5:", "2 corners", "at least 3"});
    expect_error(head + "f\n", {"cloth.obj:5:", "0 corners"});
    expect_error(head + "f 1 2 \\\n\n", {"cloth.obj:5:", "2 corners"});
    expect_error(head, {"no faces", "4 vertices"});
    expect_error(std::string("v 0 0 \0 0\n", 10), {"cloth.obj:1:"});
}

TEST_F(ObjFile, OnlyAWholeByteOrderMarkIsLeftOut) {
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_EQ(test::must(load("\xEF\xBB\xBF# of an editor\n" + triangle)).positions.size(), 3u);
    // Any other first line is read whole: here the triangle lacks the vertex of a line with another word.
    EXPECT_FALSE(load("\xEF\xBC\xA1" + triangle));
    EXPECT_FALSE(load("\xEF\xBB" + triangle));
}

TEST_F(ObjFile, AForwardIndexThatLeadsNowhereIsNamedByItsLine) {
    expect_error("f 1 2 3\nf 2 3 4\nf 1 3 6\nf 1 3 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n",
                 {"cloth.obj:3:", "vertex index 6", "has 4"});
    expect_error("f 1/2 2/1 3/1\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\n",
                 {"cloth.obj:1:", "texture coordinate index 2", "has 1"});
}

TEST_F(ObjFile, ExponentsThatLeaveAnIntermediateRangeAreRead) {
    const Mesh mesh = test::must(load("v 0e999 0 0\nv 100000000000000000000e-20 0 0\nv 0 1 0\nf 1 2 3\n"));
    EXPECT_EQ(mesh.positions[0].x, 0);
    EXPECT_EQ(mesh.positions[1].x, 1);
}

TEST_F(ObjFile, AFaceOfManyCornersIsClothWithoutACrowdedVertex) {
    // As a fan its first vertex would have a spring to each of the others, and more triangles than the 1024
    // that are taken. Cooking takes longer by more than the number of corners: each is an edge away from
    // far ones, which makes coarse levels dense.
    constexpr std::size_t corners = 1100;
    std::string text, face = "f";
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / corners;
        text.append("v ").append(std::to_string(100 * std::cos(angle))).append(" 0 ");
        text.append(std::to_string(100 * std::sin(angle))).append("\n");
        face.append(" ").append(std::to_string(i + 1));
    }
    ObjReport report;
    const Mesh mesh = test::must(load(text + face + "\n", {}, &report));
    EXPECT_EQ(report.triangulated_faces, 1u);
    EXPECT_EQ(mesh.triangles.size(), corners - 2);
    std::vector<int> triangles_at(corners);
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) ++triangles_at[vertex];
    EXPECT_LE(std::ranges::max(triangles_at), 2 * 11) << "two for each halving";

    World world = test::must(World::create({.threads = 1}));
    const ClothId id = test::must(world.add_cloth(mesh));
    const ClothInfo info = test::must(world.cloth_info(id));
    EXPECT_EQ(info.components, 1u);
    EXPECT_EQ(info.border_edges, corners);
    EXPECT_NEAR(info.mass, 0.2 * std::numbers::pi * 100 * 100, 2);
    EXPECT_FALSE(has(world.step(1.0f / 60).flags, StepFlags::state_restored));
}

TEST_F(ObjFile, LinesAreOfALimitedLengthAndCommentsOfAny) {
    constexpr std::size_t limit = 1 << 20;
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\n", face = "f 1 2 3";
    EXPECT_TRUE(load(vertices + face + std::string(limit - face.size(), ' ') + "\n"));
    expect_error(vertices + face + std::string(limit - face.size() + 1, ' ') + "\n",
                 {"cloth.obj:4:", "longer than 1048576 characters"});
    std::string joined = vertices + face;
    for (int i = 0; i < 1024; ++i) joined += std::string(1024, ' ') + "\\\n";
    expect_error(joined + "\n", {"cloth.obj:4:", "longer than 1048576 characters"});
    EXPECT_TRUE(load(vertices + face + "#" + std::string(3 * limit, 'x') + "\n"));
}

TEST_F(ObjFile, HugeFilesOfNothingAreRefusedWithoutReadingThem) {
    write(std::string(square) + "f 1 2 3\n");
    std::filesystem::resize_file(file_, std::uintmax_t{1} << 31);  // sparse: it takes no space
    Result<Mesh> mesh = load_obj(file_);
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().code, ErrorCode::malformed_file);
    EXPECT_NE(mesh.error().message.find("cloth.obj:6: the line is longer than"), std::string::npos)
        << mesh.error().message;

    std::filesystem::resize_file(file_, (std::uintmax_t{1} << 33) + 1);
    mesh = load_obj(file_);
    ASSERT_FALSE(mesh);
    EXPECT_NE(mesh.error().message.find("has 8589934593 bytes; an OBJ file may have at most 8589934592"),
              std::string::npos)
        << mesh.error().message;
}

TEST_F(ObjFile, PatternNeedsATextureCoordinateAtEveryCorner) {
    const std::string text = std::string(square) + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1/1 3//3 4\n";
    EXPECT_TRUE(load(text));
    expect_error(text, {"cloth.obj:9:", "\"3//3\"", "no texture coordinate", "pattern"},
                 {.texcoords_are_pattern = true});
}

TEST_F(ObjFile, FilesThatCannotBeRead) {
    const Result<Mesh> missing = load_obj(folder_ / "missing.obj");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::file_not_found);
    EXPECT_NE(missing.error().message.find("missing.obj"), std::string::npos);

    const Result<Mesh> directory = load_obj(folder_);
    ASSERT_FALSE(directory);
    EXPECT_EQ(directory.error().code, ErrorCode::file_not_found);
    EXPECT_NE(directory.error().message.find("directory"), std::string::npos);

    expect_error("", {"empty"});
}

TEST_F(ObjFile, FilesThatCannotBeWritten) {
    const Mesh mesh = test::fan(3);
    const Result<void> no_folder = save_obj(folder_ / "none" / "cloth.obj", mesh);
    ASSERT_FALSE(no_folder);
    EXPECT_NE(no_folder.error().message.find("cannot be written"), std::string::npos)
        << no_folder.error().message;
    EXPECT_FALSE(save_obj(folder_, mesh));
    if (std::filesystem::exists("/dev/full")) {
        EXPECT_FALSE(save_obj("/dev/full", mesh));
    }
}

TEST_F(ObjFile, SaveRefusesWhatLoadWould) {
    Mesh mesh = test::fan(3);
    mesh.triangles[1][0] = 50;
    const Result<void> saved = save_obj(file_, mesh);
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().code, ErrorCode::invalid_mesh);
    EXPECT_NE(saved.error().message.find("vertex 50"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(ObjFile, RoundTripIsExact) {
    for (const test::NamedMesh& sample : test::sound_meshes()) {
        SCOPED_TRACE(sample.name);
        ASSERT_TRUE(save_obj(file_, sample.mesh));
        const Mesh mesh = test::must(load_obj(file_));
        EXPECT_TRUE(same_bytes(mesh.positions, sample.mesh.positions));
        EXPECT_TRUE(same_bytes(mesh.texcoords, sample.mesh.texcoords));
        EXPECT_EQ(mesh.triangles, sample.mesh.triangles);
    }
}

TEST_F(ObjFile, RoundTripKeepsThePattern) {
    Mesh expected = test::tube(4, 9);
    std::swap(expected.pattern, expected.texcoords);
    ASSERT_TRUE(save_obj(file_, expected));
    const Mesh mesh = test::must(load_obj(file_, {.texcoords_are_pattern = true}));
    EXPECT_TRUE(same_bytes(mesh.pattern, expected.pattern));
    EXPECT_EQ(mesh.triangles, expected.triangles);
}

}  // namespace
}  // namespace weft
