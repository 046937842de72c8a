#include "demo/headless/frame_table.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace weft::demo {
namespace {

FrameTable three_frames() {
    FrameTable table;
    for (int frame = 1; frame <= 3; ++frame) {
        const auto time = static_cast<float>(frame);
        const StageTime stages[] = {{.name = "forces", .depth = 0, .last = time},
                                    {.name = "step", .last = 2 * time}};
        StepReport report;
        report.particles = 100;
        report.collider_contacts = static_cast<std::uint32_t>(frame);
        report.self_contacts = 7;
        table.add(stages, report);
    }
    return table;
}

TEST(FrameTable, HasOneRowPerFrame) {
    const auto file = std::filesystem::path(testing::TempDir()) / "frame_table_test.csv";
    ASSERT_TRUE(three_frames().write_csv(file).ok());
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    EXPECT_EQ(text.str(),
              "frame,forces_ms,total_ms,particles,collider_contacts,self_contacts\n"
              "0,1,2,100,1,7\n"
              "1,2,4,100,2,7\n"
              "2,3,6,100,3,7\n");
}

TEST(FrameTable, SaysWhereItCannotWrite) {
    const auto written = three_frames().write_csv("/no/such/folder/table.csv");
    ASSERT_FALSE(written.ok());
    EXPECT_NE(written.error().message.find("/no/such/folder/table.csv"), std::string::npos);
}

TEST(FrameTable, SummaryHasALinePerStage) {
    const std::string summary = three_frames().summary();
    EXPECT_EQ(std::count(summary.begin(), summary.end(), '\n'), 3);
    EXPECT_NE(summary.find("forces                     2.000     3.000     3.000     3.000"),
              std::string::npos)
        << summary;
}

TEST(Percentile, IsTheNearestRank) {
    std::vector<float> hundred;
    for (int i = 100; i >= 1; --i) hundred.push_back(static_cast<float>(i));
    EXPECT_EQ(percentile(hundred, 0.5), 50);
    EXPECT_EQ(percentile(hundred, 0.95), 95);
    EXPECT_EQ(percentile(hundred, 1.0), 100);
    EXPECT_EQ(percentile(hundred, 0.001), 1);
    EXPECT_EQ(percentile({3}, 0.5), 3);
}

}  // namespace
}  // namespace weft::demo
