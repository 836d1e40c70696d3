#pragma once

#include <cstdint>

#include "base/result.h"
#include "image/raster.h"

namespace candela {

/// How far two pictures are apart. Differences are those of values, where 1 is white: one level of
/// an 8-bit file is 1/255.
struct ImageDifference {
  int64_t pixels = 0;            ///< Of either picture.
  int64_t differing = 0;         ///< Pixels with any channel different.
  int64_t beyond_one_level = 0;  ///< Pixels with a channel different by more than 1/255.
  double mse = 0;                ///< Mean of the squared differences over all channels.
  double psnr = 0;               ///< -10 log10(mse) in decibels; infinite for equal pictures.
  double largest = 0;            ///< Of all channels.

  double LargestInLevels() const { return 255 * largest; }

  /// The values of bytes are rounded when they become floats, so the distance of two of them may
  /// exceed a whole number of levels by a trifle; this much of it does not count.
  static constexpr double kLevelSlack = 1e-4;
};

/// Compares pictures of the same size; another size is an error. Where the channels differ, grey is
/// taken as equal red, green and blue, and a missing alpha as 1. Two NaN are equal; NaN and a
/// number differ infinitely.
Result<ImageDifference> CompareImages(const Image& a, const Image& b);
Result<ImageDifference> CompareImages(const ByteImage& a, const ByteImage& b);

/// The size of the differences as a picture with the channels of the richer one but no alpha, times
/// `gain`.
Result<Image> DifferencePicture(const Image& a, const Image& b, float gain = 1);

}  // namespace candela
