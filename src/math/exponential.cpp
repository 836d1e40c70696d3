// Exponentials and logarithms by table and short series, after P. T. P. Tang, "Table-driven
// implementation of the exponential function" (1989) and "... of the logarithm function" (1990).
// The tables are computed by the compiler from their definitions.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/double_double.h"
#include "math/elementary.h"

namespace candela {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// 2 atanh(s) = ln((1 + s) / (1 - s)) for |s| <= 1/3, as the series of odd powers.
constexpr DoubleDouble TwoAtanh(DoubleDouble s) {
  DoubleDouble power = s + s;
  DoubleDouble sum = power;
  for (int n = 3; n < 80; n += 2) {
    power = power * s * s;
    sum = sum + power / DoubleDouble{static_cast<double>(n)};
  }
  return sum;
}

constexpr DoubleDouble kLn2 = TwoAtanh(DoubleDouble{1} / DoubleDouble{3});
constexpr DoubleDouble kLog2E = DoubleDouble{1} / kLn2;

// Exponentials: 2^(n/64) from the table, times e^r for the rest |r| <= ln(2)/128.

constexpr int kExpSteps = 64;

constexpr auto kPowersOfTwo = [] {
  const DoubleDouble x = kLn2 * DoubleDouble{1.0 / kExpSteps};
  DoubleDouble step{1};  // e^x by the series in Horner's form
  for (int n = 16; n > 0; --n) step = DoubleDouble{1} + step * x / DoubleDouble{double(n)};

  std::array<DoubleDouble, kExpSteps> table;
  table[0] = {1};
  for (size_t i = 1; i < table.size(); ++i) table[i] = table[i - 1] * step;
  return table;
}();

/// 2^exponent for a normal result.
double PowerOfTwo(int64_t exponent) {
  return std::bit_cast<double>(static_cast<uint64_t>(exponent + 1023) << 52);
}

/// The nearest whole number of |x| < 2^51, both ways: adding 1.5 * 2^52 leaves no bits for a
/// fraction, and what the sum's bits exceed those of 1.5 * 2^52 by is the integer.
struct Nearest {
  explicit Nearest(double x) {
    constexpr double kShift = 0x1.8p52;
    const double shifted = x + kShift;
    value = shifted - kShift;
    integer =
        static_cast<int64_t>(std::bit_cast<uint64_t>(shifted) - std::bit_cast<uint64_t>(kShift));
  }
  double value;
  int64_t integer;
};

/// 2^(n/64) * e^r, without the power of two that is left to scale with.
inline double ScaledExp(int64_t n, double r) {
  const DoubleDouble power = kPowersOfTwo[static_cast<size_t>(n) % kExpSteps];
  // e^r - 1 by its series; the next term is below 3e-20.
  const double r2 = r * r;
  const double tail = (1.0 / 6 + r * (1.0 / 24)) + r2 * (1.0 / 120 + r * (1.0 / 720));
  const double expm1 = r + r2 * (0.5 + r * tail);
  return power.hi + (power.lo + power.hi * expm1);
}

/// 2^(n/64) * e^r. The scale is applied in two steps because 2^1024 and 2^-1074 are not normal.
double Exponential(int64_t n, double r) {
  const int64_t exponent = n >> 6;
  const int64_t half = exponent >> 1;
  return ScaledExp(n, r) * PowerOfTwo(half) * PowerOfTwo(exponent - half);
}

/// 2^(x.hi + x.lo)
double Exp2(DoubleDouble x) {
  if (x.hi >= 1024) return kInfinity;
  if (x.hi <= -1080) return 0;
  const Nearest n(x.hi * kExpSteps);
  return Exponential(n.integer, ((x.hi - n.value * (1.0 / kExpSteps)) + x.lo) * kLn2.hi);
}

// Logarithms: x = 2^k m with m in [sqrt(1/2), sqrt(2)); ln(m) = ln(c) + 2 atanh((m - c) / (m + c))
// with c = i/128 next to m. Around 1 the table holds 0, so that nothing cancels.

constexpr int kFirstStep = 90;
constexpr int kLastStep = 182;

constexpr auto kLogs = [] {
  std::array<DoubleDouble, kLastStep - kFirstStep + 1> table;
  const auto ln = [&](int i) -> DoubleDouble& {
    return table[static_cast<size_t>(i - kFirstStep)];
  };
  const auto ratio = [](int i) {  // ln((i + 1) / i)
    return TwoAtanh(DoubleDouble{1} / DoubleDouble{2.0 * i + 1});
  };
  ln(128) = {0};
  for (int i = 128; i < kLastStep; ++i) ln(i + 1) = ln(i) + ratio(i);
  for (int i = 128; i > kFirstStep; --i) ln(i - 1) = ln(i) - ratio(i - 1);
  return table;
}();

/// x = 2^exponent * mantissa, with the step of the table that is nearest to the mantissa.
struct LogArgument {
  /// `x` is positive, finite and normal.
  explicit LogArgument(double x) {
    constexpr uint64_t kRootOfHalf = std::bit_cast<uint64_t>(0.70710678118654752440);
    const uint64_t bits = std::bit_cast<uint64_t>(x);
    const int64_t k = static_cast<int64_t>(bits - kRootOfHalf) >> 52;
    exponent = static_cast<double>(k);
    mantissa = std::bit_cast<double>(bits - (static_cast<uint64_t>(k) << 52));
    const int step = static_cast<int>(mantissa * 128 + 0.5);
    centre = step * (1.0 / 128);
    log_centre = &kLogs[static_cast<size_t>(step - kFirstStep)];
  }
  double exponent, mantissa, centre;
  const DoubleDouble* log_centre;
};

/// 2 atanh(s) - 2 s over 2 s^3 for |s| < 2^-8.
double AtanhTail(double s2) {
  return 1.0 / 3 + s2 * (1.0 / 5 + s2 * (1.0 / 7));
}

/// ln(mantissa) to about 2^-69 of its value.
DoubleDouble LogOfMantissa(const LogArgument& a) {
  const DoubleDouble s = DoubleDouble{a.mantissa - a.centre} /
                         TwoSum(a.mantissa, a.centre);  // the difference is exact
  const double s2 = s.hi * s.hi;
  return *a.log_centre + FastTwoSum(2 * s.hi, 2 * s.lo + 2 * s.hi * s2 * AtanhTail(s2));
}

/// Binary logarithm in double precision, off by about 2e-16 of its value or of ln(2); for float
/// results.
double FastLog2(double x) {
  const LogArgument a(x);
  const double s = (a.mantissa - a.centre) / (a.mantissa + a.centre);
  const double s2 = s * s;
  const double ln = a.log_centre->hi + (s + s) * (1 + s2 * (1.0 / 3 + s2 * (1.0 / 5)));
  return a.exponent + ln * kLog2E.hi;
}

/// Where the logarithm is not a finite number: x is 0, negative, infinite or NaN.
double LogOutsideDomain(double x) {
  return x == 0 ? -kInfinity : x > 0 ? x : kNaN;
}

bool HasFiniteLog(double x) {
  return x > 0 && x < kInfinity;
}

/// The same for every positive finite x: subnormal ones are scaled by 2^54 first.
LogArgument ArgumentOfAnySize(double x) {
  if (x >= std::numeric_limits<double>::min()) return LogArgument(x);
  LogArgument a(x * 0x1p54);
  a.exponent -= 54;
  return a;
}

DoubleDouble Log2InDoubleDouble(double x) {
  const LogArgument a = ArgumentOfAnySize(x);
  return DoubleDouble{a.exponent} + LogOfMantissa(a) * kLog2E;
}

bool IsWhole(double y) {
  return std::abs(y) >= 0x1p52 || static_cast<double>(static_cast<int64_t>(y)) == y;
}

bool IsOdd(double y) {
  return std::abs(y) < 0x1p53 && IsWhole(y) && (static_cast<int64_t>(y) & 1) != 0;
}

/// x^y outside 0 < x < infinity with finite y: what C's annex F says.
double SpecialPow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (std::isnan(x) || std::isnan(y)) return kNaN;
  const double magnitude = std::abs(x);
  if (std::isinf(y)) {
    if (magnitude == 1) return 1;
    return (magnitude > 1) == (y > 0) ? kInfinity : 0;
  }
  const bool negative = std::signbit(x) && IsOdd(y);
  double power;
  if (magnitude == 0 || std::isinf(magnitude)) {
    power = (magnitude == 0) == (y > 0) ? 0 : kInfinity;
  } else if (IsWhole(y)) {
    power = Pow(magnitude, y);
  } else {
    return kNaN;
  }
  return negative ? -power : power;
}

}  // namespace

double Exp(double x) {
  if (!(x < 710)) return x >= 710 ? kInfinity : x;
  if (x < -750) return 0;
  // x = n ln(2)/64 + r; the first part of ln(2)/64 has 33 bits, so its product with n is exact
  // (Cody and Waite, "Software manual for the elementary functions", 1980).
  constexpr double kStepHi = std::bit_cast<double>(std::bit_cast<uint64_t>(kLn2.hi / kExpSteps) &
                                                   ~((uint64_t{1} << 20) - 1));
  constexpr double kStepLo = (kLn2.hi / kExpSteps - kStepHi) + kLn2.lo / kExpSteps;
  const Nearest n(x * (kLog2E.hi * kExpSteps));
  return Exponential(n.integer, (x - n.value * kStepHi) - n.value * kStepLo);
}

double Exp2(double x) {
  return std::isnan(x) ? x : Exp2(DoubleDouble{x});
}

double Log(double x) {
  if (!HasFiniteLog(x)) return LogOutsideDomain(x);
  const LogArgument a = ArgumentOfAnySize(x);
  return (kLn2 * DoubleDouble{a.exponent} + LogOfMantissa(a)).Rounded();
}

double Log2(double x) {
  if (!HasFiniteLog(x)) return LogOutsideDomain(x);
  return Log2InDoubleDouble(x).Rounded();
}

double Pow(double x, double y) {
  if (!HasFiniteLog(x) || !std::isfinite(y)) return SpecialPow(x, y);
  // From 2^66 on only the sign of y matters, unless x is 1; this keeps the product finite.
  y = std::min(std::max(y, -0x1p66), 0x1p66);
  return Exp2(Log2InDoubleDouble(x) * DoubleDouble{y});
}

float Exp(float x) {
  return static_cast<float>(Exp(static_cast<double>(x)));
}
float Exp2(float x) {
  return static_cast<float>(Exp2(static_cast<double>(x)));
}
float Log(float x) {
  return static_cast<float>(Log(static_cast<double>(x)));
}
float Log2(float x) {
  return static_cast<float>(Log2(static_cast<double>(x)));
}

float Pow(float x, float y) {
  if (!HasFiniteLog(x) || !std::isfinite(y)) return static_cast<float>(SpecialPow(x, y));
  const double exponent = y * FastLog2(x);
  if (!(std::abs(exponent) < 160)) return exponent > 0 ? static_cast<float>(kInfinity) : 0.0f;
  const Nearest n(exponent * kExpSteps);
  const double r = (exponent - n.value * (1.0 / kExpSteps)) * kLn2.hi;
  return static_cast<float>(ScaledExp(n.integer, r) * PowerOfTwo(n.integer >> 6));
}

}  // namespace candela
