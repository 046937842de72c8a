// What the panels show, as far as it needs no picture.

#include "demo/panels/panels.h"

#include <gtest/gtest.h>

#include "demo/report_text.h"

namespace weft::demo {
namespace {

TEST(StageHistory, KeepsTheLastSteps) {
    StageHistory history;
    const int steps = static_cast<int>(StageHistory::length) + 50;
    for (int i = 0; i < steps; ++i) {
        const auto time = static_cast<float>(i);
        const StageTime stages[] = {{.name = "a", .last = time}, {.name = "step", .last = -time}};
        history.add(stages);
        EXPECT_EQ(history.at(0, 0), time);
    }
    ASSERT_EQ(history.size(), StageHistory::length);
    for (std::size_t age = 0; age < history.size(); ++age) {
        EXPECT_EQ(history.at(0, age), static_cast<float>(steps - 1) - static_cast<float>(age));
        EXPECT_EQ(history.at(1, age), -history.at(0, age));
    }
    history.clear();
    EXPECT_EQ(history.size(), 0u);
}

TEST(FlagsText, NamesTheSettingToChange) {
    EXPECT_EQ(flags_text(StepFlags::none), "");
    EXPECT_NE(flags_text(StepFlags::state_restored).find("substeps"), std::string::npos);
    EXPECT_NE(flags_text(StepFlags::contacts_dropped).find("distance"), std::string::npos);
    const std::string both = flags_text(StepFlags::state_restored | StepFlags::contacts_dropped);
    EXPECT_EQ(both, flags_text(StepFlags::state_restored) + flags_text(StepFlags::contacts_dropped));
}

}  // namespace
}  // namespace weft::demo
