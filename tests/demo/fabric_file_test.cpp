// Fabrics from files: Weft's own and measured ones.

#include "demo/options/fabric_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "garments.h"

namespace weft::demo {
namespace {

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
