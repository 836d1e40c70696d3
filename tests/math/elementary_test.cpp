// How far the elementary functions are from the truth, in units of the last place, against the long
// double functions of the system's library over dense random arguments.

#include "math/elementary.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <random>

namespace candela {
namespace {

// The bounds that the header promises for doubles.
constexpr double kBound = 0.55;
constexpr double kTrigonometricBound = 0.9;
// One rounding of a double: half an ulp, and a hair for results close to a tie.
constexpr double kFloatBound = 0.5 + 1e-5;

constexpr int kCount = 300000;

double DoubleUlps(double value, long double truth) {
  const double nearest = std::abs(static_cast<double>(truth));
  const long double ulp = std::nextafter(nearest, INFINITY) - nearest;
  return static_cast<double>(std::abs(static_cast<long double>(value) - truth) / ulp);
}

double FloatUlps(float value, long double truth) {
  const float nearest = std::abs(static_cast<float>(truth));
  const long double ulp = std::nextafter(nearest, INFINITY) - nearest;
  return static_cast<double>(std::abs(static_cast<long double>(value) - truth) / ulp);
}

/// Uniform arguments in [low, high); repeatable, as std::mt19937_64 is fully specified.
class Arguments {
 public:
  Arguments(double low, double high) : low_(low), high_(high) {}
  double Next() { return low_ + (high_ - low_) * (static_cast<double>(bits_() >> 11) * 0x1p-53); }

 private:
  std::mt19937_64 bits_{20};
  double low_, high_;
};

struct OneArgument {
  const char* name;
  double (*of_double)(double);
  float (*of_float)(float);
  long double (*truth)(long double);
  double low, high;  // of the argument, or of its binary logarithm
  bool logarithmic;
  double bound = kBound;
};

void PrintTo(const OneArgument& f, std::ostream* out) {
  *out << f.name << (f.logarithmic ? " of 2^" : " of ") << f.low << ".." << f.high;
}

class ElementaryError : public testing::TestWithParam<OneArgument> {
 protected:
  void SetUp() override {
    if (LDBL_MANT_DIG < 64) GTEST_SKIP() << "long double is not wider than double here";
  }
};

TEST_P(ElementaryError, IsWithinTheStatedBound) {
  const OneArgument& f = GetParam();
  Arguments arguments(f.low, f.high);
  double worst_double = 0, worst_float = 0, at_double = 0, at_float = 0;
  for (int i = 0; i < kCount; ++i) {
    const double next = arguments.Next();
    const double x = f.logarithmic ? std::exp2(next) * (i % 2 == 0 ? 1 : -1) : next;
    const double error = DoubleUlps(f.of_double(x), f.truth(x));
    if (!(error <= worst_double)) worst_double = error, at_double = x;

    const auto narrow = static_cast<float>(x);
    const long double truth = f.truth(narrow);
    if (!(std::abs(truth) < FLT_MAX) || std::abs(truth) < FLT_MIN) continue;
    const double float_error = FloatUlps(f.of_float(narrow), truth);
    if (!(float_error <= worst_float)) worst_float = float_error, at_float = narrow;
  }
  EXPECT_LE(worst_double, f.bound) << "at " << at_double;
  EXPECT_LE(worst_float, kFloatBound) << "at " << at_float;
}

INSTANTIATE_TEST_SUITE_P(
    All, ElementaryError,
    testing::Values(OneArgument{"Sin", Sin, Sin, std::sin, -7, 7, false, kTrigonometricBound},
                    OneArgument{"Sin", Sin, Sin, std::sin, -1e6, 1e6, false, kTrigonometricBound},
                    OneArgument{"Sin", Sin, Sin, std::sin, -60, 0, true, kTrigonometricBound},
                    OneArgument{"Cos", Cos, Cos, std::cos, -7, 7, false, kTrigonometricBound},
                    OneArgument{"Cos", Cos, Cos, std::cos, -1e6, 1e6, false, kTrigonometricBound},
                    OneArgument{"Tan", Tan, Tan, std::tan, -7, 7, false, kTrigonometricBound},
                    OneArgument{"Tan", Tan, Tan, std::tan, -1e6, 1e6, false, kTrigonometricBound},
                    OneArgument{"Asin", Asin, Asin, std::asin, -1, 1, false},
                    OneArgument{"Asin", Asin, Asin, std::asin, -60, 0, true},
                    OneArgument{"Acos", Acos, Acos, std::acos, -1, 1, false},
                    OneArgument{"Acos", Acos, Acos, std::acos, 0.999999, 1, false},
                    OneArgument{"Atan", Atan, Atan, std::atan, -2, 2, false},
                    OneArgument{"Atan", Atan, Atan, std::atan, -70, 70, true},
                    OneArgument{"Exp", Exp, Exp, std::exp, -1, 1, false},
                    OneArgument{"Exp", Exp, Exp, std::exp, -700, 709, false},
                    OneArgument{"Exp", Exp, Exp, std::exp, -60, 0, true},
                    OneArgument{"Exp2", Exp2, Exp2, std::exp2, -1020, 1024, false},
                    OneArgument{"Exp2", Exp2, Exp2, std::exp2, -1, 1, false},
                    OneArgument{"Log", Log, Log, std::log, 0.5, 2, false},
                    OneArgument{"Log", Log, Log, std::log, 0.9999, 1.0001, false},
                    OneArgument{"Log", Log, Log, std::log, 0, 1e300, false},
                    OneArgument{"Log2", Log2, Log2, std::log2, 0.5, 2, false},
                    OneArgument{"Log2", Log2, Log2, std::log2, 0.9999, 1.0001, false},
                    OneArgument{"Log2", Log2, Log2, std::log2, 0, 1e300, false}));

struct TwoArguments {
  const char* name;
  double (*of_double)(double, double);
  float (*of_float)(float, float);
  long double (*truth)(long double, long double);
  double low[2], high[2];
};

void PrintTo(const TwoArguments& f, std::ostream* out) {
  *out << f.name << " of " << f.low[0] << ".." << f.high[0] << ", " << f.low[1] << ".."
       << f.high[1];
}

class ElementaryPairError : public testing::TestWithParam<TwoArguments> {
 protected:
  void SetUp() override {
    if (LDBL_MANT_DIG < 64) GTEST_SKIP() << "long double is not wider than double here";
  }
};

TEST_P(ElementaryPairError, IsWithinTheStatedBound) {
  const TwoArguments& f = GetParam();
  Arguments unit(0, 1);
  double worst_double = 0, worst_float = 0;
  for (int i = 0; i < kCount; ++i) {
    const double a = f.low[0] + (f.high[0] - f.low[0]) * unit.Next();
    const double b = f.low[1] + (f.high[1] - f.low[1]) * unit.Next();
    const long double truth = f.truth(a, b);
    if (std::abs(truth) < 1e307L && std::abs(truth) > 1e-307L) {
      worst_double = std::max(worst_double, DoubleUlps(f.of_double(a, b), truth));
    }
    const auto narrow_a = static_cast<float>(a), narrow_b = static_cast<float>(b);
    const long double narrow = f.truth(narrow_a, narrow_b);
    if (!(std::abs(narrow) < FLT_MAX) || std::abs(narrow) < FLT_MIN) continue;
    worst_float = std::max(worst_float, FloatUlps(f.of_float(narrow_a, narrow_b), narrow));
  }
  EXPECT_LE(worst_double, kBound);
  EXPECT_LE(worst_float, kFloatBound);
}

INSTANTIATE_TEST_SUITE_P(
    All, ElementaryPairError,
    testing::Values(TwoArguments{"Atan2", Atan2, Atan2, std::atan2, {-1, -1}, {1, 1}},
                    TwoArguments{"Atan2", Atan2, Atan2, std::atan2, {-1e-3, -1}, {1e-3, 1}},
                    TwoArguments{
                        "Atan2", Atan2, Atan2, std::atan2, {-1e300, -1e300}, {1e300, 1e300}},
                    TwoArguments{"Pow", Pow, Pow, std::pow, {0, 0}, {1, 100}},  // Phong
                    TwoArguments{"Pow", Pow, Pow, std::pow, {0, -8}, {10, 8}},
                    TwoArguments{"Pow", Pow, Pow, std::pow, {0.999, -7e5}, {1.001, 7e5}},
                    TwoArguments{"Pow", Pow, Pow, std::pow, {0, -1.02}, {1e300, 1.02}}));

TEST(FastAtan2, IsWithinTheStatedBound) {
  Arguments arguments(-1, 1);
  for (int i = 0; i < kCount; ++i) {
    const double size = std::exp2(std::round(300 * arguments.Next()));
    const double y = size * arguments.Next(), x = size * arguments.Next();
    ASSERT_NEAR(FastAtan2(y, x), std::atan2(y, x), 1.5e-15) << y << " " << x;
  }
  EXPECT_EQ(FastAtan2(0, 1), 0);
  EXPECT_EQ(FastAtan2(0, -1), kPi);
  EXPECT_EQ(FastAtan2(-1, 0), -kPi / 2);
}

// The reference is built from pi in long double, so angles stay small.
TEST(Degrees, AgreeWithRadians) {
  if (LDBL_MANT_DIG < 64) GTEST_SKIP() << "long double is not wider than double here";
  const long double radians = std::acos(-1.0L) / 180;
  Arguments arguments(-44, 44);
  for (int i = 0; i < kCount; ++i) {
    const double x = arguments.Next();
    ASSERT_LE(DoubleUlps(SinDegrees(x), std::sin(x * radians)), kTrigonometricBound) << x;
    ASSERT_LE(DoubleUlps(CosDegrees(x), std::cos(x * radians)), kTrigonometricBound) << x;
    ASSERT_LE(DoubleUlps(TanDegrees(x), std::tan(x * radians)), kTrigonometricBound) << x;
  }
}

}  // namespace
}  // namespace candela
