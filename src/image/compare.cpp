#include "image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "image/channels.h"
#include "math/elementary.h"

namespace candela {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLog10Of2 = 0.30102999566398119521;

/// Size of a difference, in a form that is 0 only for values that count as equal.
double Distance(float a, float b) {
  if (a == b || (std::isnan(a) && std::isnan(b)))
    return 0;  // Infinities of one sign are equal too.
  const double distance = std::fabs(double{a} - double{b});
  return std::isnan(distance) ? kInfinity : distance;
}

Error WrongSize(const Image& a, const Image& b) {
  return {ErrorCode::kInput, fmt::format("the sizes differ: {} x {} and {} x {}", a.Width(),
                                         a.Height(), b.Width(), b.Height())};
}

bool HaveOneSize(const Image& a, const Image& b) {
  return a.Width() == b.Width() && a.Height() == b.Height();
}

/// Both pictures with the channels needed to hold either.
std::pair<Image, Image> WithCommonChannels(const Image& a, const Image& b) {
  const int m = a.Channels(), n = b.Channels();
  // Grey with alpha beside colours without needs both.
  const bool is_mixed = std::min(m, n) == 2 && std::max(m, n) == 3;
  const int channels = is_mixed ? 4 : std::max(m, n);
  return {WithChannels(a, channels), WithChannels(b, channels)};
}

}  // namespace

Result<ImageDifference> CompareImages(const Image& a, const Image& b) {
  if (!HaveOneSize(a, b)) return WrongSize(a, b);
  if (a.Channels() != b.Channels()) {
    const auto [wide_a, wide_b] = WithCommonChannels(a, b);
    return CompareImages(wide_a, wide_b);
  }
  constexpr double kOneLevel = (1 + ImageDifference::kLevelSlack) / 255;
  ImageDifference result;
  result.pixels = a.PixelCount();
  double sum = 0;
  for (int y = 0; y < a.Height(); ++y) {
    const std::span<const float> row_a = a.Row(y), row_b = b.Row(y);
    for (size_t i = 0; i < row_a.size(); i += static_cast<size_t>(a.Channels())) {
      double most = 0;
      for (size_t c = 0; c < static_cast<size_t>(a.Channels()); ++c) {
        const double distance = Distance(row_a[i + c], row_b[i + c]);
        most = std::max(most, distance);
        sum += distance * distance;
      }
      result.differing += most > 0;
      result.beyond_one_level += most > kOneLevel;
      result.largest = std::max(result.largest, most);
    }
  }
  if (!a.IsEmpty()) result.mse = sum / static_cast<double>(a.Samples().size());
  result.psnr = result.mse > 0 ? -10 * kLog10Of2 * Log2(result.mse) : kInfinity;
  return result;
}

Result<ImageDifference> CompareImages(const ByteImage& a, const ByteImage& b) {
  return CompareImages(ToFloat(a), ToFloat(b));
}

Result<Image> DifferencePicture(const Image& a, const Image& b, float gain) {
  if (!HaveOneSize(a, b)) return WrongSize(a, b);
  auto [picture, other] = WithCommonChannels(a, b);
  const std::span<float> values = picture.Samples();
  for (size_t i = 0; i < values.size(); ++i) {
    values[i] = gain * static_cast<float>(Distance(values[i], other.Samples()[i]));
  }
  // An alpha of 0, the difference of opaque pictures, would make the result invisible.
  if (picture.Channels() == 2) return WithChannels(picture, 1);
  if (picture.Channels() == 4) return WithChannels(picture, 3);
  return std::move(picture);
}

}  // namespace candela
