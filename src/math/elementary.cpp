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
}  // namespace candela
