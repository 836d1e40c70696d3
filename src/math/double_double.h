#pragma once

#include <cmath>

namespace candela {

/// An unevaluated sum hi + lo with |lo| at most half an ulp of hi: about 106 bits. It carries the
/// elementary functions past the last bit of a double, and builds their tables while compiling.
///
/// The error-free transformations are Dekker's, "A floating-point technique for extending the
/// available precision" (1971), and Knuth's two-sum. They rely on -ffp-contract=off and need
/// magnitudes between about 1e-290 and 1e290 to be exact.
struct DoubleDouble {
  double hi = 0, lo = 0;

  constexpr double Rounded() const { return hi + lo; }
  friend constexpr DoubleDouble operator-(DoubleDouble a) { return {-a.hi, -a.lo}; }
};

/// a + b exactly, for |a| >= |b| or a = 0.
constexpr DoubleDouble FastTwoSum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b exactly.
constexpr DoubleDouble TwoSum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

/// a * b exactly: each factor is cut into halves whose products fit a double.
constexpr DoubleDouble TwoProduct(double a, double b) {
  constexpr double kSplit = 0x1p27 + 1;
  const double a_scaled = kSplit * a;
  const double b_scaled = kSplit * b;
  const double a_hi = a_scaled - (a_scaled - a);
  const double b_hi = b_scaled - (b_scaled - b);
  const double a_lo = a - a_hi;
  const double b_lo = b - b_hi;
  const double product = a * b;
  return {product, ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
}

constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble sum = TwoSum(a.hi, b.hi);
  return FastTwoSum(sum.hi, sum.lo + (a.lo + b.lo));
}

constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) {
  return a + -b;
}

constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble product = TwoProduct(a.hi, b.hi);
  return FastTwoSum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double quotient = a.hi / b.hi;
  const DoubleDouble product = TwoProduct(quotient, b.hi);
  const double rest = ((a.hi - product.hi) - product.lo) + (a.lo - quotient * b.lo);
  return FastTwoSum(quotient, rest / b.hi);
}

/// The root of a number above 0, by one step of Newton's method.
inline DoubleDouble Sqrt(DoubleDouble a) {
  const double root = std::sqrt(a.hi);
  const DoubleDouble square = TwoProduct(root, root);
  return FastTwoSum(root, (((a.hi - square.hi) - square.lo) + a.lo) / (2 * root));
}

}  // namespace candela
