#include "demo/study/study_progress.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace weft::study {
namespace {

TEST(StudyProgress, TimeLeftIsByCostAndNeverNegative) {
    StudyProgress progress(4, 1);
    progress.begin("there already");
    progress.end(0.25, false);
    EXPECT_FALSE(progress.seconds_left()) << "nothing says how fast it goes";
    progress.begin("a quarter");
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    progress.end(0.25);
    ASSERT_TRUE(progress.seconds_left());
    const double for_half = *progress.seconds_left();
    EXPECT_GE(for_half, 0.004);
    progress.skip(0.25);
    EXPECT_NEAR(*progress.seconds_left(), 0.5 * for_half, 1e-9);
    progress.skip(0.3);
    EXPECT_EQ(*progress.seconds_left(), 0) << "there was more than was announced";
}

}  // namespace
}  // namespace weft::study
