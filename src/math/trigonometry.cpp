// Sine, cosine and tangent: the angle is reduced to a quarter turn around a multiple of pi/2 (W. J.
// Cody and W. Waite, "Software manual for the elementary functions", 1980), where Taylor's series
// end below the last bit.

#include <cmath>
#include <limits>

#include "math/double_double.h"
#include "math/elementary.h"

namespace candela {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// pi/2 in three parts. The first two have 33 bits, so their products with a count of quarter turns
// below 2^20 are exact.
constexpr double kHalfPi1 = 0x1.921fb544p0;
constexpr double kHalfPi2 = 0x1.0b4611a6p-34;
constexpr double kHalfPi3 = 0x1.3198a2e037073p-69;

/// An angle of at most an eighth turn past a number of quarter turns, of which the last two bits
/// count.
struct ReducedAngle {
  DoubleDouble rest;
  unsigned quarter_turns;
};

ReducedAngle Reduce(double x) {
  // Taking off turns of the double nearest to 2 pi, which is off by 3.9e-17 of its size, is the
  // same as changing x by that part.
  if (std::abs(x) > 1e6) x = std::fmod(x, 2 * kPi);
  const double turns = x * (2 / kPi);
  const auto n = static_cast<int>(turns < 0 ? turns - 0.5 : turns + 0.5);
  const DoubleDouble rest = TwoSum(x - n * kHalfPi1, -(n * kHalfPi2));
  return {rest + DoubleDouble{-(n * kHalfPi3)}, static_cast<unsigned>(n) & 3};
}

ReducedAngle ReduceDegrees(double degrees) {
  degrees = std::fmod(degrees, 360.0);
  const auto n = static_cast<int>(degrees / 90 + (degrees < 0 ? -0.5 : 0.5));
  constexpr DoubleDouble kRadians = DoubleDouble{kPi, 0x1.1a62633145c07p-53} / DoubleDouble{180};
  return {DoubleDouble{degrees - n * 90} * kRadians, static_cast<unsigned>(n) & 3};
}

struct SinCosPair {
  DoubleDouble sin, cos;
};

/// Both functions on [-pi/4, pi/4] to about 2^-58 of their value, as sums still to be rounded.
SinCosPair SinCosOfRest(DoubleDouble r) {
  const double x = r.hi;
  const double x2 = x * x;
  const double s =
      -1.0 / 6 +
      x2 * (1.0 / 120 + x2 * (-1.0 / 5040 +
                              x2 * (1.0 / 362880 +
                                    x2 * (-1.0 / 39916800 +
                                          x2 * (1.0 / 6227020800 + x2 * (-1.0 / 1307674368000 +
                                                                         x2 / 355687428096000))))));
  const double c =
      1.0 / 24 +
      x2 * (-1.0 / 720 +
            x2 * (1.0 / 40320 +
                  x2 * (-1.0 / 3628800 +
                        x2 * (1.0 / 479001600 + x2 * (-1.0 / 87178291200 + x2 / 20922789888000)))));
  // sin(x + lo) = sin x + lo cos x; cos(x + lo) = cos x - lo sin x; to first order in lo.
  const DoubleDouble half_square = TwoProduct(x, 0.5 * x);
  const DoubleDouble one_minus = FastTwoSum(1, -half_square.hi);
  return {FastTwoSum(x, x * x2 * s + r.lo * (1 - 0.5 * x2)),
          FastTwoSum(one_minus.hi, one_minus.lo - half_square.lo + (x2 * x2 * c - x * r.lo))};
}

SinCosPair SinCosOf(const ReducedAngle& angle) {
  const SinCosPair rest = SinCosOfRest(angle.rest);
  switch (angle.quarter_turns) {
    case 0:
      return rest;
    case 1:
      return {rest.cos, -rest.sin};
    case 2:
      return {-rest.sin, -rest.cos};
    default:
      return {-rest.cos, rest.sin};
  }
}

/// Both functions on [-pi/4, pi/4] in double precision, to about 1e-12 of their value.
SineAndCosine FastSinCosOfRest(double x) {
  const double x2 = x * x;
  const double s =
      x + x * x2 *
              (-1.0 / 6 +
               x2 * (1.0 / 120 +
                     x2 * (-1.0 / 5040 + x2 * (1.0 / 362880 +
                                               x2 * (-1.0 / 39916800 + x2 * (1.0 / 6227020800))))));
  const double c =
      1 - x2 * (0.5 - x2 * (1.0 / 24 -
                            x2 * (1.0 / 720 - x2 * (1.0 / 40320 - x2 * (1.0 / 3628800 -
                                                                        x2 * (1.0 / 479001600))))));
  return {s, c};
}

/// Both functions in double precision, to about 1e-12 of their value; for float results.
SineAndCosine FastSinCosOf(float angle) {
  if (!std::isfinite(angle)) return {kNaN, kNaN};
  double turned = angle;
  if (std::abs(turned) > 1e6) turned = std::fmod(turned, 2 * kPi);
  const double turns = turned * (2 / kPi);
  const auto n = static_cast<int>(turns < 0 ? turns - 0.5 : turns + 0.5);
  // The first difference is exact. No float is so near to a multiple of pi / 2 that the others lose
  // digits that a float would have.
  const double x = ((turned - n * kHalfPi1) - n * kHalfPi2) - n * kHalfPi3;
  const auto [s, c] = FastSinCosOfRest(x);
  switch (static_cast<unsigned>(n) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

/// Below this magnitude x is the sine and the tangent of x, sign of zero included.
constexpr double kTiny = 0x1p-28;

/// Turns -0 into +0 and leaves everything else.
double WithoutNegativeZero(double x) {
  return x + 0.0;
}

}  // namespace

double Sin(double x) {
  if (!std::isfinite(x)) return kNaN;
  if (std::abs(x) < kTiny) return x;
  return SinCosOf(Reduce(x)).sin.Rounded();
}

double Cos(double x) {
  if (!std::isfinite(x)) return kNaN;
  return SinCosOf(Reduce(x)).cos.Rounded();
}

double Tan(double x) {
  if (!std::isfinite(x)) return kNaN;
  if (std::abs(x) < kTiny) return x;
  const SinCosPair pair = SinCosOf(Reduce(x));
  return (pair.sin / pair.cos).Rounded();
}

double SinDegrees(double degrees) {
  if (!std::isfinite(degrees)) return kNaN;
  return WithoutNegativeZero(SinCosOf(ReduceDegrees(degrees)).sin.Rounded());
}

double CosDegrees(double degrees) {
  if (!std::isfinite(degrees)) return kNaN;
  return WithoutNegativeZero(SinCosOf(ReduceDegrees(degrees)).cos.Rounded());
}

double TanDegrees(double degrees) {
  if (!std::isfinite(degrees)) return kNaN;
  const SinCosPair pair = SinCosOf(ReduceDegrees(degrees));
  if (pair.cos.hi == 0) return std::signbit(degrees) ? -kInfinity : kInfinity;
  return WithoutNegativeZero((pair.sin / pair.cos).Rounded());
}

SineAndCosine SinCos(float x) {
  return FastSinCosOf(x);
}

float Sin(float x) {
  if (std::abs(x) < kTiny) return x;
  return static_cast<float>(FastSinCosOf(x).sin);
}

float Cos(float x) {
  return static_cast<float>(FastSinCosOf(x).cos);
}

float Tan(float x) {
  if (std::abs(x) < kTiny) return x;
  const SineAndCosine pair = FastSinCosOf(x);
  return static_cast<float>(pair.sin / pair.cos);
}

}  // namespace candela
