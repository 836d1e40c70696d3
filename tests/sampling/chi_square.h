#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "math/vec.h"

namespace candela::test {

/// Statistical tests compare a normal deviate with this. One-sided, it is exceeded by chance
/// in 1.3e-6 of all tests; seeds are fixed, so a test that passes once passes always.
inline constexpr double kLargestDeviate = 4.7;

/// Pearson's chi-square of counts against expected shares (which sum to 1), as a standard normal
/// deviate by the approximation of Wilson and Hilferty (1931). Large values mean that the counts do
/// not follow the shares. Infinite when a cell of share 0 has a count.
///
/// Strength: with 1e6 samples in 1,000 cells a density that is 2 percent too high in one half of
/// the cells and too low in the other is found with a probability of 0.99 (see
/// chi_square_test.cpp).
inline double ChiSquareDeviate(std::span<const uint64_t> counts, std::span<const double> shares) {
  double total = 0;
  for (const uint64_t count : counts) total += static_cast<double>(count);

  // Cells with fewer than 5 expected samples are merged, as the approximation needs.
  double chi_square = 0, merged_count = 0, merged_expected = 0;
  int cells = 0;
  const auto add_cell = [&](double count, double expected) {
    chi_square += (count - expected) * (count - expected) / expected;
    ++cells;
  };
  for (size_t i = 0; i < counts.size(); ++i) {
    const double expected = total * shares[i];
    const auto count = static_cast<double>(counts[i]);
    if (shares[i] == 0) {
      if (count > 0) return INFINITY;
    } else if (expected >= 5) {
      add_cell(count, expected);
    } else {
      merged_count += count;
      merged_expected += expected;
    }
  }
  if (merged_expected > 0) add_cell(merged_count, merged_expected);
  const double freedom = cells - 1;
  const double variance = 2 / (9 * freedom);
  return (std::cbrt(chi_square / freedom) - (1 - variance)) / std::sqrt(variance);
}

/// Independent uniform numbers in [0, 1): the same ones everywhere.
class UniformNumbers {
 public:
  explicit UniformNumbers(uint32_t seed) : bits_(seed) {}
  float Next() { return static_cast<float>(bits_() >> 8) * 0x1p-24f; }
  Vec2 NextPair() {
    const float x = Next();
    return {x, Next()};
  }

 private:
  std::mt19937 bits_;
};

}  // namespace candela::test
