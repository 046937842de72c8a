// Maps by vertex from a garment's file and from beside it.

#include "demo/character/garment/painted_maps.h"

#include <gtest/gtest.h>

#include "demo/character/character.h"
#include "demo/character/garment/garment_file.h"
#include "tests/demo/character/temporary_file.h"

namespace weft::demo {
namespace {

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
    for (const char* maps : {"leash all 0.02\nbackstop all 0.01\n", "leash all 50\n"}) {
        std::ofstream(beside, std::ios::binary) << maps;
        settings.garment = file.path();
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
    }
    std::filesystem::remove(beside);
}

}  // namespace
}  // namespace weft::demo
