#include "demo/options/options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace weft::demo {
namespace {

std::variant<Options, EarlyExit> parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "weft_demo");
    return parse_options(static_cast<int>(arguments.size()), arguments.data());
}

Options accepted(const std::vector<const char*>& arguments) {
    const auto parsed = parse(arguments);
    if (const auto* exit = std::get_if<EarlyExit>(&parsed)) {
        ADD_FAILURE() << exit->text;
        return {};
    }
    return std::get<Options>(parsed);
}

TEST(Options, ReadsEverything) {
    const Options o = accepted(
        {"--scene",    "curtain", "--garment",  "a.obj",        "--particles", "5000",     "--threads",
         "3",          "--wind",  "-1.5,0,2e1", "--iterations", "9",           "--method", "chebyshev",
         "--substeps", "4",       "--contact",  "off",          "--headless",  "--panels", "--frames",
         "77",         "--every", "7",          "--out",        "there",       "--size",   "640x480",
         "--trace",    "t.json",  "--fabric",   "denim"});
    EXPECT_EQ(o.scene, "curtain");
    EXPECT_EQ(o.scene_options.garment, "a.obj");
    EXPECT_EQ(o.scene_options.particles, 5000u);
    EXPECT_EQ(o.overrides.threads, 3);
    ASSERT_TRUE(o.overrides.wind);
    EXPECT_EQ(o.overrides.wind->x, -1.5f);
    EXPECT_EQ(o.overrides.wind->y, 0);
    EXPECT_EQ(o.overrides.wind->z, 20);
    EXPECT_EQ(o.overrides.iterations, 9);
    ASSERT_TRUE(o.overrides.method);
    EXPECT_TRUE(std::holds_alternative<Chebyshev>(*o.overrides.method));
    EXPECT_EQ(o.overrides.fabric, *Fabric::named("denim"));
    EXPECT_EQ(o.overrides.substeps, 4);
    EXPECT_EQ(o.overrides.contact, SelfCollisionMethod::off);
    EXPECT_TRUE(o.headless && o.panels && !o.list);
    EXPECT_EQ(o.frames, 77);
    EXPECT_EQ(o.every, 7);
    EXPECT_EQ(o.out, "there");
    EXPECT_EQ(o.width, 640);
    EXPECT_EQ(o.height, 480);
    EXPECT_EQ(o.trace, "t.json");
}

TEST(Options, LeavesTheScenesOwnSettingsAlone) {
    const Options o = accepted({});
    EXPECT_FALSE(o.overrides.wind || o.overrides.method || o.overrides.fabric || o.overrides.iterations ||
                 o.overrides.substeps || o.overrides.contact);
    EXPECT_EQ(o.scene_options.particles, 0u);
}

class BadArguments : public testing::TestWithParam<std::vector<const char*>> {};

TEST_P(BadArguments, AreRefusedInOneLine) {
    const auto parsed = parse(GetParam());
    const auto* exit = std::get_if<EarlyExit>(&parsed);
    ASSERT_NE(exit, nullptr);
    EXPECT_EQ(exit->status, 2);
    EXPECT_EQ(std::ranges::count(exit->text, '\n'), 1) << exit->text;
    EXPECT_NE(exit->text.find(GetParam().front()), std::string::npos) << exit->text;
}

using Bad = std::vector<const char*>;
INSTANTIATE_TEST_SUITE_P(
    Options, BadArguments,
    testing::Values(Bad{"--particles", "0"}, Bad{"--particles", "-5"}, Bad{"--particles", "many"},
                    Bad{"--particles", "1e99"}, Bad{"--threads", "0"}, Bad{"--threads", "257"},
                    Bad{"--wind", "1,2"}, Bad{"--wind", "1,2,3,4"}, Bad{"--wind", "1,nan,0"},
                    Bad{"--wind", "1e9,0,0"}, Bad{"--wind", "east"}, Bad{"--size", "640"},
                    Bad{"--size", "0x480"}, Bad{"--size", "640x99999"}, Bad{"--iterations", "0"},
                    Bad{"--fabric", "felt"}, Bad{"--fabric", "missing.json"}, Bad{"--substeps", "0"},
                    Bad{"--frames", "0"}, Bad{"--every", "0"}, Bad{"--method", "magic"},
                    Bad{"--contact", "maybe"}, Bad{"--export", "fbx", "--headless"}, Bad{"--contact", "7"},
                    Bad{"--contact", "-1"}, Bad{"--contact", ""}, Bad{"--particles", "nan"},
                    Bad{"--particles", "12.5"}, Bad{"--threads", "1e1"}, Bad{"--wind", "inf,0,0"},
                    Bad{"--wind", "80,80,0"}, Bad{"--substeps", "257"}, Bad{"--iterations", "10001"},
                    Bad{"--frames", "-1"}, Bad{"--size", "15x15"}, Bad{"--frames"}, Bad{"--no-such-option"}));

TEST(Options, HelpIsNoError) {
    const auto parsed = parse({"--help"});
    const auto* exit = std::get_if<EarlyExit>(&parsed);
    ASSERT_NE(exit, nullptr);
    EXPECT_EQ(exit->status, 0);
    for (const char* option :
         {"--list", "--scene", "--garment", "--particles", "--simulate", "--threads", "--wind", "--headless",
          "--frames", "--out", "--trace", "--motion", "--export"}) {
        EXPECT_NE(exit->text.find(option), std::string::npos) << option;
    }
}

TEST(Options, ChooseTheScene) {
    Options options;
    EXPECT_STREQ((*choose_scene(options))->name, "flag");
    options.scene_options.garment = "some.obj";
    EXPECT_STREQ((*choose_scene(options))->name, "garment");
    options.scene = "sheet";
    ASSERT_FALSE(choose_scene(options).ok()) << "a garment that would be left out";
    EXPECT_NE(choose_scene(options).error().message.find("some.obj"), std::string::npos);
    options.scene_options.garment.clear();
    EXPECT_STREQ((*choose_scene(options))->name, "sheet");
    options.scene = "nowhere";
    ASSERT_FALSE(choose_scene(options).ok());
    EXPECT_NE(choose_scene(options).error().message.find("nowhere"), std::string::npos);
    options.scene_options.motion = "some.bvh";
    EXPECT_FALSE(choose_scene(options).ok());
    options.scene = "sheet";
    ASSERT_FALSE(choose_scene(options).ok()) << "a motion that would be left out";
    EXPECT_NE(choose_scene(options).error().message.find("some.bvh"), std::string::npos);
    options.scene.clear();
    EXPECT_STREQ((*choose_scene(options))->name, "character");
    options.scene_options.garment = "some.obj";
    EXPECT_STREQ((*choose_scene(options))->name, "character");
    options.scene_options.motion.clear();
    options.scene_options.simulated = 2000;
    ASSERT_TRUE(choose_scene(options).ok());
    for (const char* other : {"character", "sheet"}) {
        options.scene = other;
        options.scene_options.garment = std::string_view(other) == "sheet" ? "" : "some.obj";
        ASSERT_FALSE(choose_scene(options).ok()) << "a proxy that would be left out of " << other;
        EXPECT_NE(choose_scene(options).error().message.find("--simulate"), std::string::npos);
    }
    options.scene_options = {};
    options.scene = "garment";
    EXPECT_FALSE(choose_scene(options).ok());
}

}  // namespace
}  // namespace weft::demo
