// The inverse trigonometric functions, all from the angle of a point in the plane: a table of arc
// tangents, and a short series for the rest of the angle.

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

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr DoubleDouble kPiExactly{kPi, 0x1.1a62633145c07p-53};
constexpr DoubleDouble kHalfPi{kPi / 2, 0x1.1a62633145c07p-54};

constexpr int kSteps = 64;

/// atan(i/64), each from the one before: atan(a) - atan(b) = atan((a - b) / (1 + a b)).
constexpr auto kArcTangents = [] {
  std::array<DoubleDouble, kSteps + 1> table;
  table[0] = {0};
  for (int i = 1; i <= kSteps; ++i) {
    const DoubleDouble z = DoubleDouble{kSteps} / DoubleDouble{kSteps * kSteps + i * (i - 1.0)};
    DoubleDouble power = z;
    DoubleDouble sum = z;
    for (int n = 3; n < 20; n += 2) {
      power = -(power * z * z);
      sum = sum + power / DoubleDouble{static_cast<double>(n)};
    }
    table[static_cast<size_t>(i)] = table[static_cast<size_t>(i - 1)] + sum;
  }
  return table;
}();

/// The angle of (x, y) in [0, pi/4], for 0 <= y <= x, both of moderate size.
DoubleDouble AngleInFirstOctant(DoubleDouble y, DoubleDouble x) {
  const auto step = static_cast<int>(y.hi / x.hi * kSteps + 0.5);
  const DoubleDouble c{step * (1.0 / kSteps)};
  const DoubleDouble z = (y - c * x) / (x + c * y);
  const double z2 = z.hi * z.hi;
  const double tail = -1.0 / 3 + z2 * (1.0 / 5 + z2 * (-1.0 / 7 + z2 * (1.0 / 9)));
  return kArcTangents[static_cast<size_t>(step)] + FastTwoSum(z.hi, z.lo + z.hi * z2 * tail);
}

/// The angle of (x, y) in [0, pi], for y >= 0.
DoubleDouble AngleInUpperHalf(DoubleDouble y, DoubleDouble x) {
  const bool left = x.hi < 0;
  if (left) x = -x;
  const bool steep = y.hi > x.hi;
  DoubleDouble angle = steep ? kHalfPi - AngleInFirstOctant(x, y) : AngleInFirstOctant(y, x);
  if (left) angle = kPiExactly - angle;
  return angle;
}

/// The cosine that belongs to the sine x, or the other way round: sqrt(1 - x^2), without rounding.
DoubleDouble Complement(double x) {
  const DoubleDouble square = DoubleDouble{1} - TwoProduct(x, x);
  return square.hi > 0 ? Sqrt(square) : DoubleDouble{0};
}

/// The same in plain double, to about 1e-15. For 0 <= y, both finite and not both 0.
double FastAngle(double y, double x) {
  const double abs_x = std::abs(x);
  const bool is_steep = y > abs_x;
  const double ratio = is_steep ? abs_x / y : y / abs_x;
  const auto step = static_cast<int>(ratio * kSteps + 0.5);
  const double c = step * (1.0 / kSteps);
  const double z = (ratio - c) / (1 + ratio * c);
  const double z2 = z * z;
  const double tail = -1.0 / 3 + z2 * (1.0 / 5 + z2 * (-1.0 / 7 + z2 * (1.0 / 9)));
  double angle = kArcTangents[static_cast<size_t>(step)].hi + (z + z * z2 * tail);
  if (is_steep) angle = kPi / 2 - angle;
  return std::signbit(x) ? kPi - angle : angle;
}

}  // namespace

double Atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNaN;
  double abs_y = std::abs(y);
  double abs_x = std::abs(x);
  if (std::isinf(abs_y) || std::isinf(abs_x)) {
    abs_y = std::isinf(abs_y) ? 1 : 0;
    abs_x = std::isinf(abs_x) ? 1 : 0;
  }

  double angle;
  const double ratio = abs_y / abs_x;  // NaN for 0/0
  if (!(ratio > 0x1p-60)) {
    // Along the x axis: the series of the arc tangent ends after its first term.
    angle = std::signbit(x) ? kPi : abs_y == 0 ? 0 : ratio;
  } else if (ratio > 0x1p60) {
    angle = kPi / 2;
  } else {
    // Both have about the same size; bring the larger one to [1, 2), far from overflow.
    constexpr uint64_t kExponentBits = uint64_t{0x7ff} << 52;
    double larger = std::max(abs_y, abs_x);
    if (larger < 0x1p-900) {
      abs_y *= 0x1p200;
      abs_x *= 0x1p200;
      larger *= 0x1p200;
    }
    const double scale = std::bit_cast<double>(std::bit_cast<uint64_t>(larger) & kExponentBits);
    angle = AngleInUpperHalf({abs_y / scale}, {std::copysign(abs_x / scale, x)}).Rounded();
  }
  return std::copysign(angle, y);
}

double Asin(double x) {
  if (!(std::abs(x) <= 1)) return kNaN;
  if (std::abs(x) < 0x1p-28) return x;
  return std::copysign(AngleInUpperHalf({std::abs(x)}, Complement(x)).Rounded(), x);
}

double Acos(double x) {
  if (!(std::abs(x) <= 1)) return kNaN;
  return AngleInUpperHalf(Complement(x), {x}).Rounded();
}

double Atan(double x) {
  return Atan2(x, 1);
}

// A float squared is exact in double, and so is what lies between it and 1.
float Asin(float x) {
  if (!(std::abs(x) <= 1)) return static_cast<float>(kNaN);
  const double wide = x;
  const double angle = FastAngle(std::abs(wide), std::sqrt((1 - wide) * (1 + wide)));
  return static_cast<float>(std::copysign(angle, wide));
}

float Acos(float x) {
  if (!(std::abs(x) <= 1)) return static_cast<float>(kNaN);
  const double wide = x;
  return static_cast<float>(FastAngle(std::sqrt((1 - wide) * (1 + wide)), wide));
}

float Atan(float x) {
  return Atan2(x, 1.0f);
}

double FastAtan2(double y, double x) {
  return std::copysign(FastAngle(std::abs(y), x), y);
}

float Atan2(float y, float x) {
  const bool is_plain = std::isfinite(x) && std::isfinite(y) && (x != 0 || y != 0);
  if (!is_plain) return static_cast<float>(Atan2(static_cast<double>(y), static_cast<double>(x)));
  return static_cast<float>(FastAtan2(static_cast<double>(y), static_cast<double>(x)));
}

}  // namespace candela
