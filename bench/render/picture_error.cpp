#include "picture_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/check.h"

namespace candela {

double TrimmedRelativeError(const Image& picture, const Image& reference) {
  CHECK(picture.Width() == reference.Width() && picture.Height() == reference.Height());
  constexpr double kLeastSquare = 0.01, kLeftOut = 0.001;
  std::vector<double> errors;
  for (int y = 0; y < picture.Height(); ++y) {
    for (int x = 0; x < picture.Width(); ++x) {
      double sum = 0;
      for (int c = 0; c < 3; ++c) {
        const double right = reference.At(x, y, c), difference = picture.At(x, y, c) - right;
        sum += difference * difference / std::max(right * right, kLeastSquare);
      }
      errors.push_back(std::isfinite(sum) ? sum / 3 : std::numeric_limits<double>::infinity());
    }
  }
  std::ranges::sort(errors);
  const auto kept =
      static_cast<size_t>(std::ceil(static_cast<double>(errors.size()) * (1 - kLeftOut)));
  double sum = 0;
  for (size_t i = 0; i < kept; ++i) sum += errors[i];
  return sum / static_cast<double>(kept);
}

double LargestRegionDifference(const Image& a, const Image& b) {
  CHECK(a.Width() == b.Width() && a.Height() == b.Height());
  constexpr int kSide = 8;
  double means[2][kSide][kSide] = {};
  for (int y = 0; y < a.Height(); ++y) {
    for (int x = 0; x < a.Width(); ++x) {
      const int column = x * kSide / a.Width(), row = y * kSide / a.Height();
      for (int c = 0; c < 3; ++c) {
        means[0][row][column] += a.At(x, y, c);
        means[1][row][column] += b.At(x, y, c);
      }
    }
  }
  double largest = 0;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const double one = means[0][row][column], other = means[1][row][column];
      const double brighter = std::max(one, other);
      if (brighter > 0) largest = std::max(largest, std::abs(one - other) / brighter);
    }
  }
  return largest;
}

}  // namespace candela
