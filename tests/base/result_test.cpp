#include "base/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace candela {
namespace {

Result<int> Half(int number) {
  if (number % 2 != 0) return Error{ErrorCode::kInput, "odd"};
  return number / 2;
}

TEST(Result, HoldsTheValueOrTheReason) {
  EXPECT_EQ(*Half(8), 4);
  EXPECT_TRUE(Half(8).ok());
  EXPECT_FALSE(Half(7).ok());
  EXPECT_EQ(Half(7).error().message, "odd");
  EXPECT_EQ(Half(7).error().code, ErrorCode::kInput);
}

TEST(Result, GivesItsValueAway) {
  Result<std::unique_ptr<int>> result = std::make_unique<int>(5);
  const std::unique_ptr<int> value = std::move(*result);
  EXPECT_EQ(*value, 5);
}

TEST(Result, OfNothingIsSuccessOrTheReason) {
  EXPECT_TRUE(Result<void>());
  const Result<void> failed = Error{ErrorCode::kOutput, "full"};
  EXPECT_FALSE(failed);
  EXPECT_EQ(failed.error().message, "full");
}

// Taking a value that is not there is a mistake of ours, and it stops with the place.
TEST(ResultDeath, OfAMissingValueOrError) {
  EXPECT_DEATH((void)Half(7).value(), "result.h:[0-9]+: internal error: the condition 'ok");
  EXPECT_DEATH((void)Half(8).error(), "the condition '!ok\\(\\)' does not hold");
  EXPECT_DEATH((void)Result<void>().error(), "the condition 'failed_' does not hold");
}

// The programs return these as they are.
TEST(ErrorCode, IsTheExitStatus) {
  EXPECT_EQ(static_cast<int>(ErrorCode::kInput), 1);
  EXPECT_EQ(static_cast<int>(ErrorCode::kUsage), 2);
  EXPECT_EQ(static_cast<int>(ErrorCode::kOutput), 3);
  EXPECT_EQ(static_cast<int>(ErrorCode::kResources), 4);
  EXPECT_EQ(static_cast<int>(ErrorCode::kStopped), 5);
}

}  // namespace
}  // namespace candela
