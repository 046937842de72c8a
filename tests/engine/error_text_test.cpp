#include "engine/error_text.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <random>

namespace weft {
namespace {

TEST(NumberText, IsWhatWasWritten) {
    EXPECT_EQ(number_text(static_cast<double>(0.1f)), "0.1");
    EXPECT_EQ(number_text(0.1), "0.1");
    EXPECT_EQ(number_text(-3), "-3");
    EXPECT_EQ(number_text(0), "0");
    EXPECT_EQ(number_text(100000), "100000");
    EXPECT_EQ(number_text(16777217), "16777217");  // the first whole number that is not a float
    EXPECT_EQ(number_text(1e300), "1e+300");
}

TEST(NumberText, NamesWhatIsNotANumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(number_text(nan), "nan");
    EXPECT_EQ(number_text(-nan), "nan");
    EXPECT_EQ(number_text(infinity), "inf");
    EXPECT_EQ(number_text(-infinity), "-inf");
}

TEST(NumberText, ReadsBackAsTheSameFloat) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> exponent(-37, 37), mantissa(-1, 1);
    for (int i = 0; i < 10000; ++i) {
        const float value = mantissa(random) * std::pow(10.0f, exponent(random));
        EXPECT_EQ(std::strtof(number_text(static_cast<double>(value)).c_str(), nullptr), value);
    }
}

TEST(OutOfRange, NamesTheSettingTheValueAndTheRemedy) {
    const Error error = out_of_range("ClothSettings::fabric.warp", -3, "finite and >= 0 N/m");
    EXPECT_EQ(error.code, ErrorCode::invalid_argument);
    EXPECT_EQ(error.message, "ClothSettings::fabric.warp is -3; it must be finite and >= 0 N/m");
}

}  // namespace
}  // namespace weft
