// Garments from files, and the materials that say what of them is simulated.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "demo/character/character.h"
#include "demo/character/garment/garment_file.h"
#include "demo/character/garment/garment_mesh.h"
#include "demo/character/garment/painted_maps.h"
#include "tests/demo/character/temporary_file.h"
#include "tests/demo/garments.h"

namespace weft::demo {

namespace {

/// A strip of four rows of two vertices: the upper quad is of `upper`, the two lower ones of `lower`. Its
/// seventh vertex is used by nothing.
std::string strip(const std::string& head, const std::string& upper, const std::string& lower) {
    return head + "v 0 1.2 0\nv 0.2 1.2 0\nv 0 1 0\nv 0.2 1 0.1\nv 0 0.8 0\nv 0.2 0.8 0.2\nv 9e-1 1 0\n" +
           upper + "f 1 3 4 2\n" + lower + "f 3 5 6\nf -5 -2 -4\n";
}

std::string refusal_of(const std::string& text) {
    const TemporaryFile file("refused.obj", text);
    const auto garment = read_garment(file.path());
    return garment.ok() ? std::string() : garment.error().message;
}

TEST(GarmentFile, FixesWhatIsOfNoFreeMaterial) {
    const TemporaryFile materials("cloth.mtl", "newmtl Top\nKd 1 1 1\nnewmtl Silk Free\nKd 0.2 0.4 0.6\n");
    const TemporaryFile file("strip.obj", strip("mtllib " + materials.path().filename().string() + "\n",
                                                "usemtl Top\n", "usemtl Silk Free\n"));
    const auto garment = read_garment(file.path());
    ASSERT_TRUE(garment.ok()) << garment.error().message;
    EXPECT_EQ(garment->fixed, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_TRUE(garment->stands_ready);
    EXPECT_TRUE(garment->notes.empty()) << garment->notes.front();
    EXPECT_FLOAT_EQ(garment->colour.x, 0.2f);
    EXPECT_FLOAT_EQ(garment->colour.z, 0.6f);
    EXPECT_EQ(garment->mesh.triangles.size(), 4u);
    EXPECT_FLOAT_EQ(garment->mesh.positions[1].y, 1.2f) << "+Y stays up";
}

TEST(GarmentFile, GoesOnWithoutItsMaterialsFile) {
    const TemporaryFile file("alone.obj",
                             strip("mtllib not here.mtl\n", "usemtl Top\n", "usemtl SilkFree\n"));
    const auto garment = read_garment(file.path());
    ASSERT_TRUE(garment.ok()) << garment.error().message;
    EXPECT_EQ(garment->fixed, (std::vector<std::uint32_t>{0, 1}));
    ASSERT_EQ(garment->notes.size(), 1u);
    EXPECT_NE(garment->notes[0].find("not here.mtl cannot be read"), std::string::npos);
    EXPECT_FLOAT_EQ(garment->colour.x, Garment().colour.x);

    const TemporaryFile materials("other.mtl", "newmtl SilkFree\nKd 0 1 0\n");
    const TemporaryFile lacking("lacking.obj", strip("mtllib " + materials.path().filename().string() + "\n",
                                                     "usemtl Top\n", "usemtl SilkFree\n"));
    const auto other = read_garment(lacking.path());
    ASSERT_TRUE(other.ok());
    ASSERT_EQ(other->notes.size(), 1u);
    EXPECT_NE(other->notes[0].find("has no material Top"), std::string::npos);

    const TemporaryFile none("none.obj", strip("", "usemtl Top\n", "usemtl SilkFree\n"));
    ASSERT_EQ(read_garment(none.path())->notes.size(), 1u);
}

/// A TGA picture of one red pixel over a blue one.
std::string red_over_blue() {
    std::string tga(18, '\0');
    tga[2] = 2, tga[12] = 1, tga[14] = 2, tga[16] = 24, tga[17] = 0x20;
    return tga + std::string("\0\0\xff\xff\0\0", 6);
}

TEST(GarmentFile, EachMaterialHasItsColourAndPicture) {
    const TemporaryFile picture("print.tga", red_over_blue());
    const TemporaryFile materials("printed.mtl", "newmtl Top\nKd 1 0 0.5\nnewmtl SilkFree\nmap_Kd -s 2 2 1 " +
                                                     picture.path().filename().string() +
                                                     "\nnewmtl LaceFree\nKd 0 1 0\nmap_Kd none.png\n");
    const std::string head = "mtllib " + materials.path().filename().string() + "\n";
    const TemporaryFile file("printed.obj",
                             strip(head, "usemtl Top\n", "usemtl SilkFree\n") + "usemtl LaceFree\nf 2 4 6\n");
    const auto garment = read_garment(file.path());
    ASSERT_TRUE(garment.ok()) << garment.error().message;
    const SurfaceParts& surface = garment->surface;
    ASSERT_EQ(surface.of_triangle, (std::vector<std::uint32_t>{1, 1, 2, 2, 3})) << "of a quad, two";
    ASSERT_EQ(surface.parts.size(), 4u);
    EXPECT_FLOAT_EQ(surface.parts[1].front.z, 0.5f);
    EXPECT_EQ(surface.parts[1].picture, nullptr);
    ASSERT_NE(surface.parts[2].picture, nullptr);
    EXPECT_FLOAT_EQ(surface.parts[2].front.y, 1) << "a picture without a colour is not tinted";
    EXPECT_EQ(surface.parts[2].picture->rgb, (std::vector<std::uint8_t>{255, 0, 0, 0, 0, 255}));
    EXPECT_FLOAT_EQ(surface.parts[3].front.y, 1);
    EXPECT_EQ(surface.parts[3].picture, nullptr);
    ASSERT_EQ(garment->notes.size(), 1u);
    EXPECT_NE(garment->notes[0].find("none.png"), std::string::npos);
}

TEST(GarmentFile, NotesOutlinesThatCrossThemselves) {
    const TemporaryFile materials("whole.mtl", "newmtl Top\nnewmtl SilkFree\n");
    const std::string text =
        strip("mtllib " + materials.path().filename().string() + "\n", "usemtl Top\n", "usemtl SilkFree\n") +
        "v 0 0.6 0\nv 0.2 0.6 0\nv 0.2 0.4 0\nv 0 0.4 0\n";
    EXPECT_TRUE(read_garment(TemporaryFile("square.obj", text + "f -4 -3 -2 -1\n").path())->notes.empty());
    const auto crossing = read_garment(TemporaryFile("bow_tie.obj", text + "f -4 -2 -3 -1\n").path());
    ASSERT_TRUE(crossing.ok());
    ASSERT_EQ(crossing->notes.size(), 1u);
    EXPECT_NE(crossing->notes[0].find("cross themselves: 1;"), std::string::npos);
}

TEST(GarmentFile, FacesBeforeTheFirstMaterialAreFixed) {
    const TemporaryFile file("first.obj", strip("", "", "usemtl SkirtFree\n"));
    EXPECT_EQ(read_garment(file.path())->fixed, (std::vector<std::uint32_t>{0, 1}));
    const TemporaryFile all("all.obj", strip("", "usemtl TopFree\n", "usemtl SkirtFree\n"));
    EXPECT_TRUE(read_garment(all.path())->fixed.empty());
}

TEST(GarmentFile, WithoutMaterialsIsTurnedUprightAndHeldByItsOpening) {
    WEFT_NEEDS_DATA();
    for (const auto& [name, from_waist, held] : {std::tuple("skirt-iso", true, 48u),
                                                 {"tshirt-iso", false, 30u},
                                                 {"dress-victor-iso-draped", false, 18u}}) {
        const auto garment = read_garment(data_folder() / "garments" / (std::string(name) + ".obj"));
        ASSERT_TRUE(garment.ok()) << garment.error().message;
        EXPECT_EQ(garment->from_waist, from_waist) << name;
        EXPECT_EQ(garment->fixed.size(), held) << name;
        EXPECT_FALSE(garment->stands_ready);
        EXPECT_FALSE(garment->mesh.pattern.empty());
    }
}

TEST(GarmentFile, WithOtherMaterialsIsHeldByItsOpeningInTheirColours) {
    const TemporaryFile materials("plain.mtl", "newmtl Top\nKd 1 0 0\nnewmtl Bottom\nKd 0 0 1\n");
    const TemporaryFile file("plain.obj", strip("mtllib " + materials.path().filename().string() + "\n",
                                                "usemtl Top\n", "usemtl Bottom\n"));
    const auto garment = read_garment(file.path(), 1, true);
    ASSERT_TRUE(garment.ok()) << garment.error().message;
    EXPECT_FALSE(garment->stands_ready);
    EXPECT_EQ(garment->surface.of_triangle, (std::vector<std::uint32_t>{1, 1, 2, 2}));
    EXPECT_FLOAT_EQ(garment->colour.x, 1);
    EXPECT_FALSE(garment->fixed.empty());
    EXPECT_NE(garment->notes.front().find("ends in \"Free\""), std::string::npos);
    const auto height = [](const Garment& of) { return std::ranges::max(of.mesh.positions, {}, &Vec3::y).y; };
    EXPECT_NEAR(height(*garment), 0.4f, 1e-5f);
    EXPECT_NEAR(height(*read_garment(file.path())), 0.2f, 1e-5f) << "by +Z it lies";
}

TEST(GarmentFile, AMillimetreFileFitsByItsSize) {
    const TemporaryFile file("millimetres.obj", "v 0 0 0\nv 900 0 0\nv 0 400 0\nusemtl aFree\nf 1 2 3\n");
    const auto garment = read_garment(file.path(), 0);
    ASSERT_TRUE(garment.ok()) << garment.error().message;
    EXPECT_NEAR(garment->mesh.positions[1].x, 0.9f, 1e-6f);
    EXPECT_FALSE(read_garment(file.path()).ok()) << "nobody wears 900 m";
}

TEST(GarmentFile, ErrorsNameWhatIsWrong) {
    EXPECT_NE(refusal_of("v 0 0 0\nv 100 0 0\nv 0 1 0\nusemtl aFree\nf 1 2 3\n").find("100.000000 m along x"),
              std::string::npos);
    EXPECT_NE(refusal_of("v 0 0 0\nv 0.05 0 0\nv 0 0.02 0\nusemtl aFree\nf 1 2 3\n")
                  .find("0.050000 m along x, its longest side"),
              std::string::npos);
    EXPECT_EQ(refusal_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl aFree\nf 1 2 3\n"), "") << "flat in z";
    EXPECT_NE(refusal_of("v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n").find(":2:"), std::string::npos);
    const auto missing = read_garment("no/such.obj");
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.error().code, ErrorCode::file_not_found);
}

// Maps by vertex from a garment's file and from beside it.

/// A square of four vertices, one with two texture coordinates, the upper two fixed.
constexpr const char* square = R"(v 0 0.5 0 1 0 0
v 0.5 0.5 0 1 0.5 0
v 0 0 0.3 0.25 1 0
v 0.5 0 0.3 0 0 1
vt 0 0
vt 0.5 0
vt 0.5 0.5
usemtl Top
f 1/1 3/1 2/2
usemtl BottomFree
f 2/2 3/3 4/3
)";

Result<Garment> with_maps(const std::string& maps, const std::string& obj = square) {
    const TemporaryFile file("painted.obj", obj);
    std::filesystem::path beside = file.path();
    beside.replace_extension(".maps");
    std::ofstream(beside, std::ios::binary) << maps;
    auto read = read_garment(file.path());
    std::filesystem::remove(beside);
    return read;
}

std::vector<float> values_of(const Garment& garment, Map map) {
    const auto found = std::ranges::find(garment.maps, map, &PaintedMap::map);
    return found == garment.maps.end() ? std::vector<float>() : found->values;
}

TEST(PaintedMaps, AreReadByNumberAndByColour) {
    const auto garment = with_maps(
        "# a comment\nleash all 0.2\nleash 2-3 0.1 # nearer\n\nfriction red 4\nstiffness green 2\nmass 4 "
        "3\n");
    ASSERT_TRUE(garment.ok()) << garment.error().message;
    // The third vertex has two texture coordinates: the last of the mesh is split off it.
    ASSERT_EQ(garment->mesh.positions.size(), 5u);
    EXPECT_EQ(values_of(*garment, Map::leash), (std::vector<float>{0.2f, 0.1f, 0.1f, 0.2f, 0.1f}));
    EXPECT_EQ(values_of(*garment, Map::friction), (std::vector<float>{4, 4, 1, 0, 1}));
    EXPECT_EQ(values_of(*garment, Map::stiffness), (std::vector<float>{0, 1, 2, 0, 2}));
    EXPECT_EQ(values_of(*garment, Map::mass), (std::vector<float>{1, 1, 1, 3, 1})) << "what is not named";
    EXPECT_TRUE(values_of(*garment, Map::thickness).empty());
}

TEST(PaintedMaps, PinsAreFixed) {
    const auto without = with_maps("");
    ASSERT_TRUE(without.ok()) << without.error().message;
    EXPECT_EQ(without->fixed, (std::vector<std::uint32_t>{0}));
    EXPECT_TRUE(without->maps.empty());
    const auto garment = with_maps("pin red 1\n");
    ASSERT_TRUE(garment.ok()) << garment.error().message;
    EXPECT_EQ(garment->fixed, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_TRUE(garment->maps.empty());
}

TEST(PaintedMaps, ErrorsNameTheLine) {
    for (const auto& [maps, what] : {std::pair("leash all 1\nlash all 1\n", ":2: there is no map lash"),
                                     {"leash 0 1\n", ":1: \"0\" are no vertices"},
                                     {"leash 2-5 1\n", "from 1 to 4"},
                                     {"leash 3-2 1\n", "\"3-2\" are no vertices"},
                                     {"leash purple 1\n", "\"purple\" are no vertices"},
                                     {"leash all far\n", "a map, vertices and a number"},
                                     {"leash all 1 2\n", "a map, vertices and a number"}}) {
        const auto garment = with_maps(maps);
        ASSERT_FALSE(garment.ok()) << maps;
        EXPECT_NE(garment.error().message.find(what), std::string::npos) << garment.error().message;
        EXPECT_NE(garment.error().message.find(".maps"), std::string::npos) << garment.error().message;
    }
    std::string plain = square;
    plain.replace(plain.find("0.5 0.5 0 1 0.5 0"), 17, "0.5 0.5 0");
    EXPECT_NE(with_maps("leash red 1\n", plain).error().message.find("have no colours"), std::string::npos);
}

TEST(PaintedMaps, AreReadAsTheyWereWrittenAndOtherLinesStay) {
    const TemporaryFile file("kept.obj", strip("", "usemtl Top\n", "usemtl SkirtFree\n"));
    const std::filesystem::path beside = maps_file(file.path());
    std::ofstream(beside, std::ios::binary) << "# by hand\nmass all 3\npin 1 1\n";
    const std::vector<float> weights{1, 4, 4, 0.125f, 1, 1, 9},
        leashes{unlimited, unlimited, 0, 0, 0.05f, 0.05f, unlimited};
    const std::array<PaintedMap, 2> maps{{{Map::mass, weights}, {Map::leash, leashes}}};
    ASSERT_TRUE(write_maps(file.path(), maps).ok());
    std::stringstream text;
    text << std::ifstream(beside).rdbuf();
    EXPECT_EQ(
        text.str(),
        "# by hand\npin 1 1\nmass 2-3 4\nmass 4 0.125\nmass 7 9\nleash 3-4 0\nleash 5-6 0.0500000007\n");
    const auto garment = read_garment(file.path());
    ASSERT_TRUE(garment.ok()) << garment.error().message;
    ASSERT_EQ(garment->maps.size(), 2u);
    for (const PaintedMap& painted : garment->maps)
        EXPECT_EQ(painted.values, painted.map == Map::mass ? weights : leashes);
    std::filesystem::remove(beside);
    EXPECT_FALSE(write_maps("/nowhere/at all.obj", maps).ok());
}

/// A garment whose leashes are written beside it stays by them to where the body has it.
TEST(PaintedMaps, LeashesHoldADressToTheBody) {
    Pose pose;
    CharacterSettings settings;
    settings.particles = 300;
    const Character plain = std::move(Character::create(settings)).value();
    place_joints(plain.skeleton(), plain.body().stance(plain.skeleton(), Fit().arms), pose);
    const Garment dress = make_dress(plain.body(), pose, 300);
    std::string obj;
    const auto line = [&](const char* format, auto... values) {
        char text[96];
        std::snprintf(text, sizeof text, format, values...);
        obj += text;
    };
    for (const Vec3& p : dress.mesh.positions)
        line("v %.9g %.9g %.9g\n", static_cast<double>(p.x), static_cast<double>(p.y),
             static_cast<double>(p.z));
    std::vector<bool> fixed(dress.mesh.positions.size());
    for (const std::uint32_t v : dress.fixed) fixed[v] = true;
    for (const bool free : {false, true}) {
        obj += free ? "usemtl SkirtFree\n" : "usemtl Top\n";
        for (const Triangle& t : dress.mesh.triangles)
            if ((fixed[t[0]] && fixed[t[1]] && fixed[t[2]]) != free)
                line("f %u %u %u\n", t[0] + 1, t[1] + 1, t[2] + 1);
    }
    const TemporaryFile file("leashed.obj", obj);
    std::filesystem::path beside = file.path();
    beside.replace_extension(".maps");
    const auto expect_held = [&](const char* maps, std::uint32_t simulated) {
        std::ofstream(beside, std::ios::binary) << maps;
        settings.garment = file.path();
        settings.simulated = simulated;
        auto made = Character::create(settings);
        ASSERT_TRUE(made.ok()) << made.error().message;
        auto world = World::create({.threads = 1});
        ASSERT_TRUE(made->enter(*world).ok());
        float farthest = 0;
        for (int step = 0; step < 150; ++step) {
            made->before_step(*world, step / 60.0, 1.0f / 60);
            world->step(1.0f / 60);
            const ClothView& view = *world->cloth(made->cloth());
            for (std::size_t v = 0; v < made->skin_targets().size(); ++v) {
                const Vec4& p = view.positions[view.vertex_to_particle[v]];
                if (p.w > 0)
                    farthest = std::max(farthest, (xyz(p) - to_vector(made->skin_targets()[v])).norm());
            }
        }
        if (maps[10] == '0' && maps[11] == '.')
            EXPECT_LT(farthest, 0.0201f);
        else
            EXPECT_GT(farthest, 0.03f) << "nothing else holds it so near";
        if (simulated == 0) return;
        EXPECT_EQ(made->garment().fine.positions.size(), dress.mesh.positions.size());
        EXPECT_NEAR(static_cast<float>(made->garment().mesh.positions.size()), static_cast<float>(simulated),
                    0.2f * static_cast<float>(simulated));
        EXPECT_FALSE(made->garment().fixed.empty());
        EXPECT_LT(made->garment().fixed.size(), made->garment().mesh.positions.size() * 9 / 10);
    };
    for (const std::uint32_t simulated : {0u, 160u})
        for (const char* maps : {"leash all 0.02\nbackstop all 0.01\n", "leash all 50\n"})
            ASSERT_NO_FATAL_FAILURE(expect_held(maps, simulated)) << simulated;
    std::filesystem::remove(beside);
}

constexpr std::uint32_t around = 12;

/// A tube along +Z from 0 to 1, radius 0.5, slit along one line of its pattern as sewn cloth is: the seam's
/// two sides are two vertices at one position.
Mesh tube() {
    Mesh mesh;
    for (std::uint32_t ring = 0; ring < 3; ++ring) {
        for (std::uint32_t i = 0; i <= around; ++i) {
            const float angle = 2 * 3.14159265f * static_cast<float>(i % around) / around;
            const float height = 0.5f * static_cast<float>(ring);
            mesh.positions.push_back({0.5f * std::cos(angle), 0.5f * std::sin(angle), height});
            mesh.pattern.push_back({2 * 3.14159265f * 0.5f * static_cast<float>(i) / around, height});
        }
    }
    const auto at = [](std::uint32_t ring, std::uint32_t i) { return ring * (around + 1) + i; };
    for (std::uint32_t ring = 0; ring < 2; ++ring) {
        for (std::uint32_t i = 0; i < around; ++i) {
            mesh.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i + 1)});
            mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)});
        }
    }
    return mesh;
}

std::size_t distinct_positions(const Mesh& mesh) {
    std::set<std::array<float, 3>> positions;
    for (const Vec3& p : mesh.positions) positions.insert({p.x, p.y, p.z});
    return positions.size();
}

TEST(GarmentMesh, StandsOnItsLowestPoint) {
    Mesh mesh = tube();
    stand_upright(mesh, 0.3f);
    const auto height = [](const Vec3& p) { return p.y; };
    EXPECT_NEAR(std::ranges::min(mesh.positions, {}, height).y, 0.3f, 1e-6);
    EXPECT_NEAR(std::ranges::max(mesh.positions, {}, height).y, 1.3f, 1e-6);
    // The first vertex was at (0.5, 0, 0); rotation about +X keeps it on the +X side.
    EXPECT_NEAR(mesh.positions[0].x, 0.5f, 1e-6);
}

TEST(GarmentMesh, HangsByItsHighestOpeningOncePerPosition) {
    Mesh mesh = tube();
    stand_upright(mesh, 0);
    const std::vector<std::uint32_t> ring = highest_opening(mesh);
    EXPECT_EQ(ring.size(), around) << "the seam is one position, and no opening";
    for (const std::uint32_t vertex : ring) EXPECT_NEAR(mesh.positions[vertex].y, 1, 1e-6);
}

TEST(GarmentMesh, HangsAClosedMeshByItsTop) {
    Mesh tetrahedron;
    tetrahedron.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    tetrahedron.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    EXPECT_EQ(highest_opening(tetrahedron), std::vector<std::uint32_t>{3});
}

TEST(GarmentMesh, RefinementQuartersTrianglesAndKeepsSeamsSewn) {
    const Mesh coarse = tube();
    const Mesh fine = refined(coarse);
    EXPECT_EQ(fine.triangles.size(), 4 * coarse.triangles.size());
    EXPECT_EQ(fine.pattern.size(), fine.positions.size());
    // A slit tube of 3 rings becomes one of 5 with twice the points; seams welded, each ring closes.
    EXPECT_EQ(distinct_positions(fine), 5u * 2u * around);
}

TEST(GarmentMesh, DropsAPatternThatIsNotInMetres) {
    Mesh metres = tube(), unit = tube();
    for (Vec2& p : unit.pattern) p = {0.1f * p.x, 0.1f * p.y};
    drop_unfit_pattern(metres);
    drop_unfit_pattern(unit);
    EXPECT_FALSE(metres.pattern.empty());
    EXPECT_TRUE(unit.pattern.empty());
}

}  // namespace

}  // namespace weft::demo
