// Command lines, methods by name, and files of fabrics.

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <vector>

#include "demo/options/fabric_file.h"
#include "demo/options/method_table.h"
#include "demo/options/options.h"
#include "demo/panels/panels.h"
#include "garments.h"
#include "small_world.h"

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
                    Bad{"--compare", "magic"}, Bad{"--contact", "maybe"},
                    Bad{"--export", "fbx", "--headless"}, Bad{"--contact", "7"}, Bad{"--contact", "-1"},
                    Bad{"--contact", ""}, Bad{"--particles", "nan"}, Bad{"--particles", "12.5"},
                    Bad{"--threads", "1e1"}, Bad{"--wind", "inf,0,0"}, Bad{"--wind", "80,80,0"},
                    Bad{"--substeps", "257"}, Bad{"--iterations", "10001"}, Bad{"--frames", "-1"},
                    Bad{"--size", "15x15"}, Bad{"--frames"}, Bad{"--no-such-option"}));

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
    options.scene = "character";
    EXPECT_TRUE(choose_scene(options).ok());
    options.scene_options.garment.clear();
    for (const char* other : {"character", "sheet"}) {
        options.scene = other;
        ASSERT_FALSE(choose_scene(options).ok()) << "a proxy that would be left out of " << other;
        EXPECT_NE(choose_scene(options).error().message.find("--simulate"), std::string::npos);
    }
    options.scene_options = {};
    options.scene = "garment";
    EXPECT_FALSE(choose_scene(options).ok());
}

// The table of methods: complete, and all in it can be had.

TEST(Methods, AreFoundByNameAndByWhatTheyHold) {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < all_methods().size(); ++i) {
        const NamedMethod& each = all_methods()[i];
        EXPECT_EQ(each.method.index(), i) << each.name;
        EXPECT_EQ(find_method(each.name), &each);
        EXPECT_EQ(&entry_of(each.method), &each);
        names.insert(each.name);
    }
    EXPECT_EQ(names.size(), std::variant_size_v<Method>);
    EXPECT_EQ(find_method("magic"), nullptr);
    EXPECT_EQ(find_method(""), nullptr);
}

TEST(Methods, TakeIterationsWhereTheyIterate) {
    for (const NamedMethod& each : all_methods()) {
        Method method = each.method;
        set_iterations(method, 123);
        EXPECT_EQ(method.index(), each.method.index());
        EXPECT_EQ(iterations_of(method).value_or(123), 123);
        EXPECT_EQ(iterations_of(method).has_value(), !std::holds_alternative<SymplecticEuler>(method));
    }
}

// Fabrics from files: Weft's own and measured ones.

class FabricFile : public testing::Test {
  protected:
    ~FabricFile() override { std::filesystem::remove(file_); }

    Result<Fabric> load(const std::string& text) {
        std::ofstream(file_) << text;
        return load_fabric(file_);
    }
    void expect_complaint(const std::string& text, const std::string& about) {
        const auto fabric = load(text);
        ASSERT_FALSE(fabric.ok()) << text;
        EXPECT_EQ(fabric.error().code, ErrorCode::malformed_file);
        EXPECT_NE(fabric.error().message.find(file_.string()), std::string::npos) << fabric.error().message;
        EXPECT_NE(fabric.error().message.find(about), std::string::npos) << fabric.error().message;
    }

    std::filesystem::path file_ =
        std::filesystem::path(testing::TempDir()) /
        (std::string("weft_") + testing::UnitTest::GetInstance()->current_test_info()->name() + ".json");
};

const std::string rows_of_stretching =
    "[[200,1,1000,50],[200,1,1000,-20],[200,1,1000,70],[200,1,1000,60],[200,1,1000,60],[200,1,1000,60]]";
const std::string rows_of_bending = "[[4e-5,4e-5,4e-5,4e-5,4e-5],[8e-5,8e-5,8e-5,8e-5,8e-5],[0,0,0,0,0]]";

TEST_F(FabricFile, HasTheFieldsOfAFabric) {
    const auto fabric = load(
        R"({"areal_density": 0.3, "warp": 500, "weft": 450, "shear": 30, "bending": 3e-5, "damping": 1e-3})");
    ASSERT_TRUE(fabric.ok()) << fabric.error().message;
    EXPECT_FLOAT_EQ(fabric->areal_density, 0.3f);
    EXPECT_FLOAT_EQ(fabric->warp, 500);
    EXPECT_FLOAT_EQ(fabric->weft, 450);
    EXPECT_FLOAT_EQ(fabric->shear, 30);
    EXPECT_FLOAT_EQ(fabric->bending, 3e-5f);
    EXPECT_FLOAT_EQ(fabric->damping, 1e-3f);
}

TEST_F(FabricFile, LeavesWhatItDoesNotNameAtItsDefault) {
    const auto fabric = load(R"({"bending": 1e-4})");
    ASSERT_TRUE(fabric.ok()) << fabric.error().message;
    Fabric expected;
    expected.bending = 1e-4f;
    EXPECT_EQ(*fabric, expected);
}

TEST_F(FabricFile, ComplainsAboutTheKey) {
    expect_complaint(R"({"warp": -3})", "warp is -3; it must be a number from 0");
    expect_complaint(R"({"warp": 2e9})", "1000000000");
    expect_complaint(R"({"bending": "stiff"})", "bending is \"stiff\"");
    expect_complaint(R"({"areal_density": 0})", "0.0001");
    expect_complaint(R"({"strech": 400})", "no \"strech\"; it has areal_density, warp, weft");
    expect_complaint("", "JSON object");
    expect_complaint("[1, 2]", "JSON object");
    expect_complaint(R"({"warp": 400)", "JSON object");
    expect_complaint(R"({"warp": nan})", "JSON object");
}

TEST_F(FabricFile, CanBeAMeasuredOne) {
    const auto fabric = load(R"({"density": 0.25, "stretching": )" + rows_of_stretching + R"(, "bending": )" +
                             rows_of_bending + "}");
    ASSERT_TRUE(fabric.ok()) << fabric.error().message;
    EXPECT_FLOAT_EQ(fabric->areal_density, 0.25f);
    EXPECT_FLOAT_EQ(fabric->warp, 1000);
    EXPECT_FLOAT_EQ(fabric->weft, 200);
    EXPECT_FLOAT_EQ(fabric->shear, 60) << "the negative sample counts for nothing";
    EXPECT_FLOAT_EQ(fabric->bending, 1.5e-5f) << "a quarter of the positive ones' mean";
}

TEST_F(FabricFile, OfAMeasuredOneStiffeningIsFitted) {
    // Tension at a strain of 0.1 along the axis of 200 to 500, and the other of 1000 to 2500.
    const std::string text =
        R"({"density": 0.25, "stretching": [[200,1,1000,50],[500,1,1,50],[9,1,9,50],[9,1,9,50],[9,1,9,50],)"
        R"([1,1,2500,50]], "bending": )" +
        rows_of_bending + "}";
    std::ofstream(file_) << text;
    const auto fabric = load_fabric(file_, MeasuredStretch::stiffening);
    ASSERT_TRUE(fabric.ok()) << fabric.error().message;
    const auto tension = [&](float stiffness) { return stiffness * 0.1f * (1 + fabric->stiffening * 0.1f); };
    EXPECT_NEAR(tension(fabric->weft), (200 + 300 * 0.6f) * 0.105f * 1.1f, 1);
    EXPECT_NEAR(tension(fabric->warp), (1000 + 1500 * 0.6f) * 0.105f * 1.1f, 5);
    EXPECT_EQ(*find_fabric("stiffening:" + file_.string()), *fabric);
    EXPECT_EQ(load_fabric(file_)->stiffening, 0);
    EXPECT_FLOAT_EQ(load(R"({"stiffening": 12})")->stiffening, 12);
    expect_complaint(R"({"stiffening": 1001})", "stiffening is 1001; it must be a number from 0");
}

TEST_F(FabricFile, ComplainsAboutAMeasuredOnesTables) {
    expect_complaint(R"({"stretching": )" + rows_of_stretching + "}", "density is missing");
    expect_complaint(R"({"density": 0.2, "bending": )" + rows_of_bending + "}", "6 rows of 4 numbers");
    expect_complaint(R"({"density": 0.2, "stretching": [[1,2,3]], "bending": )" + rows_of_bending + "}",
                     "6 rows of 4 numbers");
    expect_complaint(R"({"density": 0.2, "stretching": )" + rows_of_stretching + "}", "3 rows");
    expect_complaint(
        R"({"density": -1, "stretching": )" + rows_of_stretching + R"(, "bending": )" + rows_of_bending + "}",
        "areal_density is -1");
    expect_complaint(R"({"density": 0.2, "colour": 3})", "no \"colour\"");
}

TEST(FindFabric, TakesNamesAndFiles) {
    const auto denim = find_fabric("denim");
    ASSERT_TRUE(denim.ok());
    EXPECT_EQ(*denim, *Fabric::named("denim"));
    const auto none = find_fabric("felt");
    ASSERT_FALSE(none.ok());
    EXPECT_NE(none.error().message.find(".json"), std::string::npos) << none.error().message;
}

/// Presets that name one of the measured fabrics have its figures.
TEST(MeasuredFabrics, AreWhereThePresetsComeFrom) {
    WEFT_NEEDS_DATA();
    for (const auto& [name, file] : {std::pair("denim", "11oz-black-denim"),
                                     {"t-shirt", "gray-interlock"},
                                     {"trousers", "royal-target"},
                                     {"tablecloth", "white-dots-on-blk"},
                                     {"light-jacket", "tango-red-jet-set"}}) {
        const auto measured = load_fabric(data_folder() / "fabrics" / (std::string(file) + ".json"));
        ASSERT_TRUE(measured.ok()) << measured.error().message;
        const Fabric preset = *Fabric::named(name);
        for (float Fabric::*field :
             {&Fabric::areal_density, &Fabric::warp, &Fabric::weft, &Fabric::shear, &Fabric::bending})
            EXPECT_NEAR(preset.*field, (*measured).*field, 0.01f * (*measured).*field) << name;
    }
}

TEST(MeasuredFabrics, AllTenCanBeReadAndHung) {
    WEFT_NEEDS_DATA();
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "fabrics")) {
        if (entry.path().extension() != ".json") continue;
        const auto fabric = load_fabric(entry.path());
        ASSERT_TRUE(fabric.ok()) << fabric.error().message;
        EXPECT_GT(fabric->shear, 10) << entry.path();
        const auto stiffening = load_fabric(entry.path(), MeasuredStretch::stiffening);
        ASSERT_TRUE(stiffening.ok()) << stiffening.error().message;
        EXPECT_GE(stiffening->stiffening, 1.5f) << entry.path();
        EXPECT_LE(stiffening->stiffening, 116) << entry.path();
        EXPECT_GE(fabric->warp, fabric->weft) << entry.path();
        auto world = World::create();
        ClothSettings settings;
        settings.fabric = *fabric;
        EXPECT_TRUE(world->add_cloth(*make_sheet({.rows = 4, .columns = 4}), settings).ok()) << entry.path();
        ++count;
    }
    EXPECT_EQ(count, 10);
}

}  // namespace

}  // namespace weft::demo
