// Single values of the elementary functions: exact ones, special ones, and stored bits.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/elementary.h"

namespace candela {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kTinyDouble = std::numeric_limits<double>::denorm_min();

bool IsPlusZero(double x) {
  return x == 0 && !std::signbit(x);
}
bool IsMinusZero(double x) {
  return x == 0 && std::signbit(x);
}

TEST(Degrees, AreExactWhereTheResultIs) {
  for (const double turn : {0.0, 360.0, -360.0, 3.6e17}) {
    EXPECT_TRUE(IsPlusZero(SinDegrees(turn)));
    EXPECT_EQ(CosDegrees(turn), 1);
  }
  EXPECT_EQ(SinDegrees(90), 1);
  EXPECT_TRUE(IsPlusZero(CosDegrees(90)));
  EXPECT_TRUE(IsPlusZero(SinDegrees(180)));
  EXPECT_EQ(CosDegrees(180), -1);
  EXPECT_EQ(SinDegrees(-90), -1);
  EXPECT_EQ(SinDegrees(270), -1);
  EXPECT_TRUE(IsPlusZero(CosDegrees(-270)));
  EXPECT_EQ(SinDegrees(30), 0.5);
  EXPECT_EQ(SinDegrees(-150), -0.5);
  EXPECT_EQ(CosDegrees(60), 0.5);
  EXPECT_EQ(CosDegrees(240), -0.5);
  EXPECT_EQ(TanDegrees(45), 1);
  EXPECT_EQ(TanDegrees(135), -1);
  EXPECT_TRUE(IsPlusZero(TanDegrees(180)));
  EXPECT_EQ(TanDegrees(90), kInf);
  EXPECT_EQ(TanDegrees(-90), -kInf);
  EXPECT_TRUE(std::isnan(SinDegrees(kInf)));
}

TEST(Trigonometry, SpecialValues) {
  EXPECT_TRUE(IsMinusZero(Sin(-0.0)));
  EXPECT_TRUE(IsMinusZero(Tan(-0.0)));
  EXPECT_EQ(Cos(0.0), 1);
  for (const double x : {kInf, -kInf, kNaN}) {
    EXPECT_TRUE(std::isnan(Sin(x)));
    EXPECT_TRUE(std::isnan(Cos(x)));
    EXPECT_TRUE(std::isnan(Tan(x)));
  }
}

TEST(Trigonometry, OfAnEighthTurnIsThatOfAnyAngleToTheLastBitsOfAFloat) {
  const float limit = 0.785398185f;
  for (int i = -100000; i <= 100000; ++i) {
    const float x = limit * (static_cast<float>(i) / 100000);
    const FloatSineAndCosine small = SinCosOfEighthTurn(x);
    const SineAndCosine any = SinCos(x);
    ASSERT_NEAR(double{small.sin}, any.sin, 1e-7 * std::abs(any.sin)) << x;
    ASSERT_NEAR(double{small.cos}, any.cos, 1e-7 * any.cos) << x;
  }
}

// Beyond 1e6 the angle is off by less than half an ulp of itself, so the pair still lies on the
// circle and the sine is that of a neighbour.
TEST(Trigonometry, HugeAnglesStayOnTheCircle) {
  for (double x = 1e6; x < 1e300; x *= 1.37) {
    const double s = Sin(x), c = Cos(x);
    ASSERT_NEAR(s * s + c * c, 1, 4e-16) << x;
    ASSERT_EQ(Sin(-x), -s);
    if (x < 1e12) {
      ASSERT_NEAR(s, std::sin(x), 0x1p-53 * x + 1e-15) << x;
    }
  }
}

TEST(InverseTrigonometry, SpecialValues) {
  EXPECT_EQ(Asin(1.0), kPi / 2);
  EXPECT_EQ(Asin(-1.0), -kPi / 2);
  EXPECT_EQ(Asin(0.5), 0x1.0c152382d7366p-1);  // pi/6
  EXPECT_TRUE(IsMinusZero(Asin(-0.0)));
  EXPECT_EQ(Acos(1.0), 0);
  EXPECT_EQ(Acos(-1.0), kPi);
  EXPECT_EQ(Acos(0.0), kPi / 2);
  EXPECT_EQ(Atan(1.0), kPi / 4);
  EXPECT_EQ(Atan(kInf), kPi / 2);
  EXPECT_EQ(Atan(-kInf), -kPi / 2);
  EXPECT_TRUE(IsMinusZero(Atan(-0.0)));
  for (const double x : {1.0000001, -1.0000001, kInf, kNaN}) {
    EXPECT_TRUE(std::isnan(Asin(x)));
    EXPECT_TRUE(std::isnan(Acos(x)));
  }
}

TEST(Atan2, SpecialValues) {
  EXPECT_TRUE(IsPlusZero(Atan2(0.0, 0.0)));
  EXPECT_TRUE(IsMinusZero(Atan2(-0.0, 1.0)));
  EXPECT_EQ(Atan2(0.0, -0.0), kPi);
  EXPECT_EQ(Atan2(-0.0, -1.0), -kPi);
  EXPECT_EQ(Atan2(1.0, 0.0), kPi / 2);
  EXPECT_EQ(Atan2(-1.0, -0.0), -kPi / 2);
  EXPECT_EQ(Atan2(1.0, -1.0), 3 * (kPi / 4));
  EXPECT_EQ(Atan2(kInf, kInf), kPi / 4);
  EXPECT_EQ(Atan2(-kInf, -kInf), -3 * (kPi / 4));
  EXPECT_EQ(Atan2(5.0, kInf), 0);
  EXPECT_EQ(Atan2(5.0, -kInf), kPi);
  EXPECT_EQ(Atan2(kTinyDouble, kTinyDouble), kPi / 4);
  EXPECT_EQ(Atan2(1e308, 1e308), kPi / 4);
  EXPECT_EQ(Atan2(1e-320, 1.0), 1e-320);
  EXPECT_TRUE(std::isnan(Atan2(kNaN, 1.0)));
}

TEST(Exponential, SpecialValues) {
  EXPECT_EQ(Exp(0.0), 1);
  EXPECT_EQ(Exp(kInf), kInf);
  EXPECT_EQ(Exp(-kInf), 0);
  EXPECT_EQ(Exp(709.79), kInf);
  EXPECT_EQ(Exp(-746.0), 0);
  EXPECT_TRUE(std::isnan(Exp(kNaN)));
  EXPECT_TRUE(std::isnan(Exp2(kNaN)));
  for (int i = -1074; i < 1024; ++i) ASSERT_EQ(Exp2(static_cast<double>(i)), std::ldexp(1.0, i));
  EXPECT_EQ(Exp2(1024.0), kInf);
  EXPECT_EQ(Exp2(-1076.0), 0);
  EXPECT_EQ(Exp(89.0f), std::numeric_limits<float>::infinity());
}

TEST(Logarithm, SpecialValues) {
  EXPECT_TRUE(IsPlusZero(Log(1.0)));
  EXPECT_EQ(Log(0.0), -kInf);
  EXPECT_EQ(Log(-0.0), -kInf);
  EXPECT_EQ(Log(kInf), kInf);
  EXPECT_TRUE(std::isnan(Log(-1.0)));
  EXPECT_TRUE(std::isnan(Log(kNaN)));
  EXPECT_TRUE(std::isnan(Log2(-kInf)));
  for (int i = -1074; i < 1024; ++i) ASSERT_EQ(Log2(std::ldexp(1.0, i)), i);
}

template <class T>
void ExpectSpecialPowers() {
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  for (const T x : {T{0}, -T{0}, T{1}, T{-3.5}, inf, -inf, nan}) {
    EXPECT_EQ(Pow(x, T{0}), 1) << x;
    EXPECT_EQ(Pow(T{1}, x), 1) << x;
  }
  EXPECT_TRUE(IsPlusZero(Pow(T{0}, T{2.5})));
  EXPECT_TRUE(IsPlusZero(Pow(-T{0}, T{2})));
  EXPECT_TRUE(IsMinusZero(Pow(-T{0}, T{3})));
  EXPECT_EQ(Pow(T{0}, T{-1}), inf);
  EXPECT_EQ(Pow(-T{0}, T{-1}), -inf);
  EXPECT_EQ(Pow(T{-2}, T{3}), -8);
  EXPECT_EQ(Pow(T{-2}, T{-2}), T{0.25});
  EXPECT_TRUE(std::isnan(Pow(T{-2}, T{0.5})));
  EXPECT_EQ(Pow(T{0.5}, inf), 0);
  EXPECT_EQ(Pow(T{0.5}, -inf), inf);
  EXPECT_EQ(Pow(T{2}, inf), inf);
  EXPECT_EQ(Pow(T{-1}, inf), 1);
  EXPECT_EQ(Pow(inf, T{2}), inf);
  EXPECT_EQ(Pow(-inf, T{3}), -inf);
  EXPECT_TRUE(IsMinusZero(Pow(-inf, T{-3})));
  EXPECT_EQ(Pow(T{2}, T{10000}), inf);
  EXPECT_EQ(Pow(T{2}, T{-10000}), 0);
  EXPECT_EQ(Pow(std::numeric_limits<T>::max(), std::numeric_limits<T>::max()), inf);
  EXPECT_TRUE(std::isnan(Pow(nan, T{2})));
  EXPECT_TRUE(std::isnan(Pow(T{2}, nan)));
}

TEST(Power, SpecialValuesOfDoubles) {
  ExpectSpecialPowers<double>();
}
TEST(Power, SpecialValuesOfFloats) {
  ExpectSpecialPowers<float>();
}

TEST(Power, IsExactForSmallWholeNumbers) {
  for (int base = 2; base <= 9; ++base) {
    double power = 1;
    for (int n = 1; n <= 16; ++n) {
      power *= base;
      ASSERT_EQ(Pow(static_cast<double>(base), static_cast<double>(n)), power);
    }
  }
  EXPECT_EQ(Pow(2.0f, -149.0f), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(Pow(0.5f, 20.0f), 0x1p-20f);
}

// Walks over neighbouring floats, where a seam between two table entries would show as a step back.
TEST(Power, HighlightNeverFallsTowardsItsCentre) {
  for (const float shininess : {1.0f, 3.7f, 32.0f, 200.0f}) {
    float before = 0;
    for (float x = 0.89f; x < 1; x = std::nextafter(x, 1.0f)) {
      const float power = Pow(x, shininess);
      ASSERT_LE(before, power) << x << " " << shininess;
      before = power;
    }
  }
}

TEST(Elementary, AreMonotonicBetweenNeighbours) {
  double sine = Sin(0.7), log = Log(0.99), exp = Exp(0.99), atan = Atan(0.99);
  double x = 0.7, y = 0.99;
  for (int i = 0; i < 100000; ++i) {
    x = std::nextafter(x + 1e-9, 2.0);
    y = std::nextafter(y + 1e-7, 2.0);
    ASSERT_LE(sine, Sin(x));
    ASSERT_LE(log, Log(y));
    ASSERT_LE(exp, Exp(y));
    ASSERT_LE(atan, Atan(y));
    sine = Sin(x), log = Log(y), exp = Exp(y), atan = Atan(y);
  }
}

// Bits recorded once. Any machine, compiler or option that changes them breaks equal pictures.
TEST(Elementary, BitsAreTheSameEverywhere) {
  const double golden[] = {0x1.aed548f090ceep-1,  0x1.24daa9c527e96p-5, 0x1.bf809b25497f6p-1,
                           -0x1.9a2f7ef858b7dp-1, 0x1.493c43acb164dp+1, 0x1.bb44b13b62571p-3,
                           0x1.380159e14f6ffp-2,  0x1.398db88c873c9p+1, 0x1.5e4c36ca0118ap+1,
                           0x1.2e259bb85be85p-5,  0x1.3b2c47bff8329p+0, 0x1.26bb1bbb55516p+1,
                           0x1.95c01a39fbd68p+0,  0x1.0cb88c9b80916p-18};
  const double now[] = {Sin(1.0),         Sin(1e5),  Sin(1e22),   Cos(2.5),         Tan(1.2),
                        SinDegrees(12.5), Asin(0.3), Acos(-0.77), Atan2(3.0, -7.0), Exp(-3.3),
                        Exp2(0.3),        Log(10.0), Log2(3.0),   Pow(0.37, 12.5)};
  for (size_t i = 0; i < std::size(now); ++i) EXPECT_EQ(now[i], golden[i]) << i;
  EXPECT_EQ(Pow(0.97f, 32.0f), 0x1.825d02p-2f);

  // A hash over many bits: 10,000 arguments through every function.
  uint64_t hash = 0;
  const auto mix = [&](double value) {
    hash = (hash ^ std::bit_cast<uint64_t>(value)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  };
  for (int i = 1; i <= 10000; ++i) {
    const double x = i * 0.00137;
    mix(Sin(x)), mix(Cos(x)), mix(Tan(x)), mix(SinDegrees(x)), mix(Asin(x / 14)), mix(Acos(x / 14));
    mix(Atan(x)), mix(Exp(x)), mix(Exp2(-x)), mix(Log(x)), mix(Log2(x)), mix(Pow(x, x));
    mix(Pow(static_cast<float>(x), 3.3f));
  }
  EXPECT_EQ(hash, 5951991356235154326u);
}

}  // namespace
}  // namespace candela
