// What happens to who reads a Result without a look at it.

#include <gtest/gtest.h>

#include <memory>
#include <string>

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
