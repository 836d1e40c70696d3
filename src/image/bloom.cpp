#include "image/bloom.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "math/elementary.h"

namespace candela {
namespace {

constexpr double kRadiusOverDeviation[] = {3, 9, 27};

/// The right half of a kernel along one axis; the middle is the first weight. All of it, left and
/// right, sums to 1.
using HalfKernel = std::vector<double>;

HalfKernel MakeKernel(double deviation) {
  const auto reach = static_cast<size_t>(std::floor(3 * deviation));
  HalfKernel kernel{1};
  double sum = 1;
  for (size_t i = 1; i <= reach; ++i) {
    const double x = static_cast<double>(i) / deviation;
    kernel.push_back(Exp(-x * x / 2));
    sum += 2 * kernel.back();
  }
  for (double& weight : kernel) weight /= sum;
  return kernel;
}

/// Adds up weighted spans: in the order of its calls, the same for each of the sums.
class WeightedSum {
 public:
  explicit WeightedSum(size_t size) : sums_(size) {}

  void Clear() { std::fill(sums_.begin(), sums_.end(), 0.0); }
  /// Adds `values` to the sums from `first` on.
  void Add(size_t first, std::span<const float> values, double weight) {
    double* sums = sums_.data() + first;
    for (size_t i = 0; i < values.size(); ++i) sums[i] += weight * static_cast<double>(values[i]);
  }
  std::span<const double> sums() const { return sums_; }

 private:
  std::vector<double> sums_;
};

void StoreTo(std::span<float> row, std::span<const double> values) {
  std::transform(values.begin(), values.end(), row.begin(),
                 [](double value) { return static_cast<float>(value); });
}

void BlurAlongRows(const HalfKernel& kernel, const Image& from, Image* to) {
  const auto depth = static_cast<size_t>(from.Channels());
  ParallelFor(from.Height(), [&](int64_t y) {
    const std::span<const float> row = from.Row(static_cast<int>(y));
    WeightedSum sum(row.size());
    sum.Add(0, row, kernel[0]);
    for (size_t i = 1; i < kernel.size() && i * depth < row.size(); ++i) {
      const size_t left = row.size() - i * depth;
      sum.Add(0, row.last(left), kernel[i]);
      sum.Add(i * depth, row.first(left), kernel[i]);
    }
    StoreTo(to->Row(static_cast<int>(y)), sum.sums());
  });
}

/// Gives the sum of each row and its number to `take`, which is called concurrently.
template <class Take>
void BlurAlongColumns(const HalfKernel& kernel, const Image& from, const Take& take) {
  ParallelFor(from.Height(), [&](int64_t row) {
    const auto y = static_cast<int>(row);
    WeightedSum sum(from.RowSize());
    sum.Add(0, from.Row(y), kernel[0]);
    for (int i = 1; i < static_cast<int>(kernel.size()); ++i) {
      const double weight = kernel[static_cast<size_t>(i)];
      if (y >= i) sum.Add(0, from.Row(y - i), weight);
      if (i < from.Height() - y) sum.Add(0, from.Row(y + i), weight);
    }
    take(y, sum.sums());
  });
}

}  // namespace

void AddBloom(const Bloom& bloom, Image* picture) {
  if (!(bloom.strength > 0) || picture->IsEmpty()) return;
  const auto strength = static_cast<double>(bloom.strength);
  const double part = strength / std::size(kRadiusOverDeviation);
  const Image before = *picture;
  for (float& value : picture->Samples()) {
    value = static_cast<float>((1 - strength) * static_cast<double>(value));
  }
  Image along_rows(picture->Width(), picture->Height(), picture->Channels());
  for (const double ratio : kRadiusOverDeviation) {
    const HalfKernel kernel = MakeKernel(static_cast<double>(bloom.radius) / ratio);
    BlurAlongRows(kernel, before, &along_rows);
    BlurAlongColumns(kernel, along_rows, [&](int y, std::span<const double> sums) {
      const std::span<float> row = picture->Row(y);
      for (size_t i = 0; i < row.size(); ++i) {
        row[i] = static_cast<float>(static_cast<double>(row[i]) + part * sums[i]);
      }
    });
  }
}

}  // namespace candela
