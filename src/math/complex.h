#pragma once

#include <cmath>

namespace candela {

/// A complex number. The standard one multiplies and divides in ways that differ between compilers.
struct Complex {
  double re = 0, im = 0;

  friend constexpr Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
  friend constexpr Complex operator-(Complex a, Complex b) { return {a.re - b.re, a.im - b.im}; }
  friend constexpr Complex operator*(Complex a, Complex b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend constexpr Complex operator*(Complex a, double s) { return {a.re * s, a.im * s}; }
  /// `b` is not 0, nor so large or small that its square overflows.
  friend constexpr Complex operator/(Complex a, Complex b) {
    return Complex{a.re * b.re + a.im * b.im, a.im * b.re - a.re * b.im} *
           (1 / (b.re * b.re + b.im * b.im));
  }
};

/// The square of the length.
constexpr double Norm(Complex z) {
  return z.re * z.re + z.im * z.im;
}

/// The root with a real part that is not negative, or for a negative number without imaginary part
/// the one above the real line.
inline Complex Sqrt(Complex z) {
  const double length = std::sqrt(Norm(z));
  const double larger = std::sqrt((length + std::abs(z.re)) / 2);
  if (larger == 0) return {};
  const double lesser = z.im / (2 * larger);
  if (z.re >= 0) return {larger, lesser};
  return z.im >= 0 ? Complex{lesser, larger} : Complex{-lesser, -larger};
}

}  // namespace candela
