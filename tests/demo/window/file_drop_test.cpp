// Files of other programs, dropped on the window.

#include <cstring>
#include <filesystem>
#include <fstream>

#include "tests/demo/window/file_drop.h"
#include "tests/demo/window/window.h"

namespace weft::demo {
namespace {

class WindowFiles : public Window {
  protected:
    static std::filesystem::path folder() {
        return std::filesystem::path(testing::TempDir()) / "weft_dropped_files";
    }
    void SetUp() override {
        Window::SetUp();
        std::filesystem::create_directories(folder());
    }
    void TearDown() override { std::filesystem::remove_all(folder()); }

    /// A square of cloth, upright, as a glTF file with nobody in it.
    static std::string square() {
        constexpr int cells = 8;
        std::vector<float> corners;
        const auto add = [&](int x, int y) {
            corners.insert(corners.end(), {0.1f * static_cast<float>(x), 0.1f * static_cast<float>(y), 0.0f});
        };
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x) {
                add(x, y), add(x + 1, y), add(x + 1, y + 1);
                add(x, y), add(x + 1, y + 1), add(x, y + 1);
            }
        std::string bytes(corners.size() * sizeof(float), ' ');
        std::memcpy(bytes.data(), corners.data(), bytes.size());
        std::ofstream(folder() / "square.bin", std::ios::binary) << bytes;
        const std::string length = std::to_string(bytes.size());
        std::ofstream(folder() / "square.gltf")
            << R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
            << R"("buffers":[{"uri":"square.bin","byteLength":)" << length
            << R"(}],"bufferViews":[{"buffer":0,"byteLength":)" << length
            << R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)"
            << corners.size() / 3 << "}]}";
        return (folder() / "square.gltf").string();
    }
};

TEST_F(WindowFiles, AreTakenWhenTheyAreDropped) {
    std::optional<FileDrop> drop;
    const auto begin = [&](const std::string& file) {
        return at_once([&drop, file](const AppFrame&) { drop.emplace(file, "Weft"); });
    };
    const auto goes_on = [&](const AppFrame&) { return drop->goes_on(); };
    const std::string settings = (folder() / "wind.json").string(), other = (folder() / "a.txt").string();
    std::ofstream(settings) << R"({"wind": {"velocity": [1.5, 0, 2]}})";
    std::ofstream(other) << "?";
    play("flag",
         {wait(2), begin(square()), goes_on, wait(3), at_once([](const AppFrame& frame) {
              EXPECT_STREQ(frame.simulation.entry().name, "garment");
              EXPECT_EQ(frame.panels.message, "");
              EXPECT_EQ(first_cloth(frame).positions.size(), 81u) << "one for each corner of cells";
              EXPECT_GT(
                  std::ranges::count_if(first_cloth(frame).positions, [](const Vec4& p) { return p.w == 0; }),
                  0)
                  << "it hangs";
          }),
          begin(settings), goes_on, wait(2), at_once([](const AppFrame& frame) {
              EXPECT_EQ(frame.simulation.world().settings().wind.velocity.z, 2);
              EXPECT_EQ(frame.wind.velocity().x, 1.5f);
          }),
          begin(other), goes_on, wait(2), at_once([](const AppFrame& frame) {
              EXPECT_NE(frame.panels.message.find("a.txt is no OBJ, glTF or JSON file"), std::string::npos)
                  << frame.panels.message;
              EXPECT_STREQ(frame.simulation.entry().name, "garment");
          })});
}

TEST_F(WindowFiles, AMillimetreSheetHangsByItsEnd) {
    const std::string sheet = (folder() / "sheet.obj").string();
    Mesh mesh = *make_sheet({.rows = 9, .columns = 9, .u = {1000, 0, 0}, .v = {0, 0, -1000}});
    ASSERT_TRUE(save_obj(sheet, mesh).ok());
    std::optional<FileDrop> drop;
    play(
        "flag",
        {wait(2), at_once([&](const AppFrame&) { drop.emplace(sheet, "Weft"); }),
         [&](const AppFrame&) { return drop->goes_on(); }, wait(3), at_once([](const AppFrame& frame) {
             EXPECT_STREQ(frame.simulation.entry().name, "garment");
             EXPECT_TRUE(frame.panels.own_file) << "its choices are shown";
             EXPECT_NE(frame.panels.message.find("units of 1 mm"), std::string::npos) << frame.panels.message;
             const ClothView cloth = first_cloth(frame);
             EXPECT_NEAR(cloth.bounds.upper.y - cloth.bounds.lower.y, 1, 0.05f);
             const auto held = std::ranges::count_if(cloth.positions, [](const Vec4& p) { return p.w == 0; });
             EXPECT_EQ(held, 17) << "of 289: one row";
         })});
}

}  // namespace
}  // namespace weft::demo
