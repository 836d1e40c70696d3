#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "base/check.h"

namespace candela {

/// A sum of floats in fixed point: the terms may come in any order and any grouping, the result has
/// the same bits. This is what makes pictures independent of threads and tiles.
///
/// Each term is rounded once to a multiple of 2^-44 (5.7e-14; floats of 1e-6 and more lose nothing)
/// and limited to +-kLargestTerm; after that everything is integers. The sum is exact for 2^23
/// terms of any size, for as many terms as one likes when their sum stays below 2^63; beyond that
/// it wraps around, as unsigned integers do: wrong, but still the same for every order.
class ExactSum {
 public:
  /// Terms beyond it, infinities included, count as this (1.1e12).
  static constexpr float kLargestTerm = 0x1p40f;

  constexpr ExactSum() = default;

  /// `term` must not be NaN.
  constexpr void Add(float term) {
    DCHECK(term == term);
    if (!(term < kLargestTerm)) term = kLargestTerm;
    if (term < -kLargestTerm) term = -kLargestTerm;
    // The fraction lies in [-1/2, 1/2]; both differences and the product are exact.
    const Rounded whole(static_cast<double>(term));
    const Rounded units((static_cast<double>(term) - whole.value) * kUnits);
    AddUnits(whole.integer, units.integer);
  }

  /// The value of a sum of this one term.
  static constexpr double OfOne(float term) {
    ExactSum sum;
    sum.Add(term);
    return sum.ToDouble();
  }

  /// Adds all terms of the other sum.
  constexpr ExactSum& operator+=(const ExactSum& other) {
    AddUnits(other.whole_, other.fraction_);
    return *this;
  }

  /// Correctly rounded while the sum is below 2^53 in magnitude, within one ulp beyond.
  constexpr double ToDouble() const {
    return static_cast<double>(static_cast<int64_t>(whole_)) +
           static_cast<double>(fraction_) * (1 / kUnits);
  }

  /// Everything that it is, to be kept in a file.
  constexpr std::array<uint64_t, 2> Words() const { return {whole_, fraction_}; }
  static constexpr ExactSum FromWords(uint64_t whole, uint64_t fraction) {
    ExactSum sum;
    sum.AddUnits(whole, fraction);
    return sum;
  }

  friend constexpr bool operator==(const ExactSum&, const ExactSum&) = default;

 private:
  /// The whole number nearest to |x| < 2^51, ties to even, as a double and in two's complement:
  /// adding 1.5 * 2^52 leaves no bits for a fraction and shows the integer in the low ones.
  /// Conversion instructions would take twice the time.
  struct Rounded {
    static constexpr double kShift = 0x1.8p52;
    explicit constexpr Rounded(double x)
        : value((x + kShift) - kShift),
          integer(std::bit_cast<uint64_t>(x + kShift) - std::bit_cast<uint64_t>(kShift)) {}
    double value;
    uint64_t integer;
  };

  static constexpr int kFractionBits = 44;
  static constexpr double kUnits = 0x1p44;

  // The carry goes over at once, so equal sums have equal bits. C++20 integers are two's complement
  // and shift right by division rounded down.
  constexpr void AddUnits(uint64_t whole, uint64_t units) {
    const uint64_t total = fraction_ + units;
    const auto carry = static_cast<int64_t>(total) >> kFractionBits;
    whole_ += whole + static_cast<uint64_t>(carry);
    fraction_ = total & ((uint64_t{1} << kFractionBits) - 1);
  }

  uint64_t whole_ = 0;     ///< rounded down, two's complement
  uint64_t fraction_ = 0;  ///< in units of 2^-44, below 1
};

}  // namespace candela
