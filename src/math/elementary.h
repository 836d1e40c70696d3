#pragma once

namespace candela {

inline constexpr double kPi = 3.14159265358979323846;

// Elementary functions whose results are the same bits on every machine and compiler: the system's
// library chooses its code by processor. They use only + - x / and sqrt, which IEEE 754 fixes.

/// Sine and cosine of an angle in degrees; exact at multiples of 90.
double SinDegrees(double degrees);
double CosDegrees(double degrees);
double TanDegrees(double degrees);

/// Binary logarithm of a positive number.
double Log2(double x);

}  // namespace candela
