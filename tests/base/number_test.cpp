#include "base/number.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

TEST(ParseFloat, TakesSignFractionAndExponent) {
  EXPECT_EQ(ParseFloat(".5"), 0.5f);
  EXPECT_EQ(ParseFloat("+.5"), 0.5f);
  EXPECT_EQ(ParseFloat("-2"), -2.0f);
  EXPECT_EQ(ParseFloat("5E-1"), 0.5f);
  EXPECT_EQ(ParseFloat("1.e0"), 1.0f);
}

TEST(ParseFloat, UnderflowIsZero) {
  EXPECT_EQ(ParseFloat("1e-400"), 0.0f);
  EXPECT_EQ(ParseFloat("-0.0001e-99999999999999999999"), 0.0f);
  EXPECT_EQ(ParseFloat("0e99999999999999999999"), 0.0f);
}

TEST(ParseFloat, RejectsWhatIsNotOneFiniteDecimalNumber) {
  for (const char* text : {"",      "+",        "-",    ".",       "+-1",
                           "1.2.3", "1,5",      "0x10", "nan",     "inf",
                           "-inf",  "infinity", "1e",   "1e+",     "1f",
                           " 1",    "1 ",       "1e39", "-1e9999", "0.001e99999999999999999999"}) {
    EXPECT_EQ(ParseFloat(text), std::nullopt) << text;
  }
}

TEST(ParseInteger, IsCheckedIn64Bits) {
  EXPECT_EQ(ParseInteger("+7"), 7);
  EXPECT_EQ(ParseInteger("-9223372036854775808"), INT64_MIN);
  for (const char* text : {"", "+", "+-1", "9223372036854775808", "1.0", "1e3", "0x1"}) {
    EXPECT_EQ(ParseInteger(text), std::nullopt) << text;
  }
}

TEST(IsTooLarge, IsTrueOnlyForNumbersBeyondAFloat) {
  for (const char* text :
       {"1e39", "-1e39", "+340282360000000000000000000000000000000", "1e999999"}) {
    EXPECT_TRUE(IsTooLarge(text)) << text;
  }
  for (const char* text : {"1e38", "0e999999", "1e-999999", "inf", "1e39x", "x", "", "-"}) {
    EXPECT_FALSE(IsTooLarge(text)) << text;
  }
}

}  // namespace
}  // namespace candela
