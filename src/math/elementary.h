#pragma once

namespace candela {

inline constexpr double kPi = 3.14159265358979323846;

// Elementary functions whose results are the same bits on every machine and compiler: the system's
// library chooses its code by processor. They use + - x / and sqrt, which IEEE 754 fixes, integer
// and bit operations, and fmod, whose result is always exact.
//
// Errors of the double versions, measured by tests/math/elementary_test.cpp: sines, cosines and
// tangents are within 0.9 ulp, everything else within 0.55 ulp (subnormal results within 1 ulp),
// but for `SinCos` and `FastAtan2`. The float versions, but for `SinCosOfEighthTurn`, round a
// double result once: nearly all of them are correctly rounded.
//
// NaN gives NaN, and so does an argument outside the domain. All functions may be called
// concurrently.

/// Sine, cosine and tangent of an angle in radians. Beyond |x| = 1e6 the result is the one of an
/// angle that differs from x by less than half an ulp of x. Infinite angles give NaN.
double Sin(double x);
double Cos(double x);
double Tan(double x);
float Sin(float x);
float Cos(float x);
float Tan(float x);

/// Both of an angle in radians at the price of one, to about 1e-12 of their value.
struct SineAndCosine {
  double sin, cos;
};
SineAndCosine SinCos(float x);
/// The same for an angle of at most an eighth turn, |x| <= pi/4, to 1e-7 of their value and much
/// faster: minimax polynomials (E. Remez, 1934) in floats, whose rounding is most of the error.
struct FloatSineAndCosine {
  float sin, cos;
};
inline FloatSineAndCosine SinCosOfEighthTurn(float x) {
  const float x2 = x * x;
  const float s = -0.166666549f + x2 * (8.33217815e-3f + x2 * -1.95172990e-4f);
  const float c = 4.16666469e-2f + x2 * (-1.38873675e-3f + x2 * 2.44384516e-5f);
  return {x + x * x2 * s, 1 - (0.5f * x2 - x2 * x2 * c)};
}

/// The same of an angle in degrees, of any size; exact at multiples of 90 (where a zero is +0 and
/// the tangent +-infinity), at 30, 45, 60 where the result is 1/2 or 1, and so on around the
/// circle.
double SinDegrees(double degrees);
double CosDegrees(double degrees);
double TanDegrees(double degrees);

/// Inverse functions in radians: asin and atan in [-pi/2, pi/2], acos in [0, pi].
double Asin(double x);
double Acos(double x);
double Atan(double x);
float Asin(float x);
float Acos(float x);
float Atan(float x);

/// The angle of the point (x, y) in [-pi, pi], with the special values of IEC 60559: the signs of
/// zeros count, and infinities stand for the limit of equal growth, so Atan2(inf, inf) is pi/4.
double Atan2(double y, double x);
float Atan2(float y, float x);
/// The same to about 1e-15 and several times as fast, for finite numbers that are not both 0.
double FastAtan2(double y, double x);

/// e^x and 2^x; 0 and infinity beyond the range of the type.
double Exp(double x);
double Exp2(double x);
float Exp(float x);
float Exp2(float x);

/// Natural and binary logarithm; -infinity at 0. The binary one is exact at powers of two.
double Log(double x);
double Log2(double x);
float Log(float x);
float Log2(float x);

/// x^y. As in C: pow(x, 0) and pow(1, y) are 1 for every x and y, even NaN; a negative x needs a
/// whole y. The float version is the fast one, for highlights: about 10 ns.
double Pow(double x, double y);
float Pow(float x, float y);

}  // namespace candela
