// Sequences as USD text, read back by a small parser of the part of the format that they use.

#include "demo/export/usd_text.h"

#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace weft::demo {
namespace {

/// The file's attributes as text, by name: what stands between "name =" and the end of the line or brace.
class UsdFile {
  public:
    explicit UsdFile(const std::filesystem::path& file) {
        std::stringstream all;
        all << std::ifstream(file).rdbuf();
        text_ = all.str();
    }
    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] std::string value(const std::string& name) const {
        const std::size_t at = text_.find(name + " = ");
        if (at == text_.npos) return {};
        const std::size_t from = at + name.size() + 3;
        return text_.substr(from, text_.find(text_[from] == '{' ? '}' : '\n', from) - from);
    }
    /// All numbers in a text, in order.
    static std::vector<float> numbers(const std::string& list) {
        std::vector<float> found;
        for (const char* at = list.c_str(); *at != '\0';) {
            char* end = nullptr;
            const float value = std::strtof(at, &end);
            if (end != at) found.push_back(value);
            at = end == at ? at + 1 : end;
        }
        return found;
    }
    /// The samples of an attribute by time.
    [[nodiscard]] std::map<int, std::vector<float>> samples(const std::string& name) const {
        std::map<int, std::vector<float>> found;
        std::istringstream lines(value(name + ".timeSamples"));
        for (std::string line; std::getline(lines, line);)
            if (const std::size_t colon = line.find(':'); colon != line.npos)
                found[std::atoi(line.c_str())] = numbers(line.substr(colon + 1));
        return found;
    }

  private:
    std::string text_;
};

TEST(UsdText, ReadsBackAsItWasWritten) {
    const Mesh mesh = make_sheet({.rows = 3, .columns = 4}).value();
    const auto file = std::filesystem::path(testing::TempDir()) / "weft_sequence.usda";
    auto usd = UsdText::create(file, mesh, {0.25f, 0.5f, 0.75f}, 0.5f, 60);
    ASSERT_TRUE(usd.ok()) << usd.error().message;
    std::vector<std::vector<Vec3>> frames;
    for (int frame = 0; frame < 3; ++frame) {
        frames.push_back(mesh.positions);
        for (Vec3& p : frames.back()) p.y += std::sin(3 * p.x + static_cast<float>(frame)) / 3;
        ASSERT_TRUE(usd->add(frames.back()).ok());
    }
    EXPECT_FALSE(usd->add(std::span(frames[0]).first(5)).ok()) << "a frame of other points";
    ASSERT_TRUE(usd->close().ok());

    const UsdFile read(file);
    EXPECT_TRUE(read.text().starts_with("#usda 1.0\n"));
    EXPECT_EQ(read.value("upAxis"), "\"Y\"");
    EXPECT_EQ(read.value("metersPerUnit"), "1");
    EXPECT_EQ(read.value("timeCodesPerSecond"), "60");
    EXPECT_EQ(UsdFile::numbers(read.value("endTimeCode")), std::vector<float>{2});
    EXPECT_EQ(UsdFile::numbers(read.value("inputs:diffuseColor")), (std::vector<float>{0.25f, 0.5f, 0.75f}));
    EXPECT_EQ(read.value("rel material:binding"), "</cloth/fabric>");
    const auto counts = UsdFile::numbers(read.value("faceVertexCounts"));
    const auto corners = UsdFile::numbers(read.value("faceVertexIndices"));
    EXPECT_EQ(counts, std::vector<float>(mesh.triangles.size(), 3));
    ASSERT_EQ(corners.size(), 3 * mesh.triangles.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
        EXPECT_EQ(corners[i], static_cast<float>(mesh.triangles[i / 3][i % 3]));
    EXPECT_EQ(UsdFile::numbers(read.value("primvars:st")).size(), 2 * mesh.texcoords.size());
    const auto points = read.samples("points"), normals = read.samples("normals");
    ASSERT_EQ(points.size(), 3u);
    ASSERT_EQ(normals.size(), 3u);
    for (int frame = 0; frame < 3; ++frame) {
        const std::vector<float>&p = points.at(frame), &n = normals.at(frame);
        const std::vector<Vec3>& written = frames[static_cast<std::size_t>(frame)];
        ASSERT_EQ(p.size(), 3 * written.size());
        ASSERT_EQ(n.size(), p.size());
        for (std::size_t v = 0; v < written.size(); ++v) {
            EXPECT_TRUE(p[3 * v] == written[v].x && p[3 * v + 1] == written[v].y &&
                        p[3 * v + 2] == written[v].z)
                << "to the bit, vertex " << v;
            EXPECT_NEAR(std::hypot(n[3 * v], n[3 * v + 1], n[3 * v + 2]), 1, 1e-5f);
            EXPECT_GT(n[3 * v + 1], 0.5f) << "the sheet's front is up";
        }
    }
    EXPECT_FALSE(std::filesystem::exists(file.string() + ".normals")) << "nothing else is left";
    std::filesystem::remove(file);
}

TEST(UsdText, NamesTheFileThatItCannotWrite) {
    const auto usd = UsdText::create("/no/such/folder/sequence.usda", make_sheet().value(), {}, 1, 60);
    ASSERT_FALSE(usd.ok());
    EXPECT_NE(usd.error().message.find("sequence.usda cannot be written"), std::string::npos);
}

}  // namespace
}  // namespace weft::demo
