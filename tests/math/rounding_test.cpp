// What compilers may not do with numbers, and have done.
#include <gtest/gtest.h>

#include "math/vec.h"

namespace candela {
namespace {

/// Stays a float, whatever the compiler thinks of it.
float Rounded(double x) {
  volatile float rounded = static_cast<float>(x);
  return rounded;
}

// GCC 12 used numbers in double as they were, here, where it made vectors of them.
TEST(Rounding, ToFloatIsKeptOnTheWayBackToDouble) {
  for (int i = 1; i < 100; ++i) {
    const Vec3d origin{0.1 * i, -1.0 / i, 0.3};
    const Vec3 w = ToFloat(Vec3d{0.7 / i, 0.6, -0.2 * i});
    const double t = 1.0 / 3 + i;
    const Vec3 q = ToFloat(origin + ToDouble(w) * t);
    const Vec3d sum = origin + ToDouble(w) * t;
    const Vec3 kept{Rounded(sum.x), Rounded(sum.y), Rounded(sum.z)};
    EXPECT_EQ(NormalizeAnyLength(q), NormalizeAnyLength(kept)) << i;
  }
}

}  // namespace
}  // namespace candela
