// A Result that is read without a test ends the process; numbers of messages read back.

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <memory>
#include <random>
#include <string>

#include "engine/error_text.h"
#include "weft/error.h"

namespace weft::test {

namespace {

const Error stale{ErrorCode::stale_id, "ClothId {3, 1} is of an object that was removed"};

TEST(Result, HandsOutWhatItHolds) {
    Result<std::unique_ptr<int>> made = std::make_unique<int>(4);
    EXPECT_EQ(**made, 4);
    EXPECT_EQ(*std::move(made).value(), 4);
    int number = 5;
    const Result<int&> there = number;
    EXPECT_EQ(&*there, &number);
    EXPECT_EQ(Result<int>(stale).error().message, stale.message);
    EXPECT_EQ(Result<void>(stale).error().code, ErrorCode::stale_id);
}

TEST(ResultDeathTest, EndsWithTheMessageWhereAnErrorIsReadAsAValue) {
    Result<std::string> value = stale;
    const Result<const std::string&> view = stale;
    EXPECT_DEATH((void)*value, "ClothId .3, 1. is of an object that was removed");
    EXPECT_DEATH((void)value->size(), "removed");
    EXPECT_DEATH((void)std::move(value).value(), "removed");
    EXPECT_DEATH((void)*view, "removed");
    EXPECT_DEATH((void)view->size(), "removed");
}

TEST(ResultDeathTest, EndsWhereAnErrorIsReadThatIsNone) {
    const int number = 1;
    EXPECT_DEATH((void)Result<int>(1).error(), "holds none");
    EXPECT_DEATH((void)Result<const int&>(number).error(), "holds none");
    EXPECT_DEATH((void)Result<void>().error(), "holds none");
}

}  // namespace

}  // namespace weft::test

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
