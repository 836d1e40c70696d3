#include "math/elementary.h"

#include <cmath>

namespace candela {
double SinDegrees(double degrees) {
  return std::sin(degrees * kPi / 180);
}
double CosDegrees(double degrees) {
  return std::cos(degrees * kPi / 180);
}
double TanDegrees(double degrees) {
  return std::tan(degrees * kPi / 180);
}

// x = m 2^e with m near 1; ln m = 2 artanh((m - 1) / (m + 1)) as a series.
double Log2(double x) {
  if (std::isinf(x)) return x;
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0.70710678118654752440) {
    m *= 2;
    --exponent;
  }
  const double z = (m - 1) / (m + 1);  // at most 0.172 in size, so the last term is below 1e-17
  double sum = 0;
  for (int k = 21; k >= 1; k -= 2) sum = sum * z * z + 1.0 / k;
  constexpr double kTwoOverLn2 = 2.88539008177792681472;
  return exponent + kTwoOverLn2 * z * sum;
}
}  // namespace candela
