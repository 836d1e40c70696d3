#pragma once

#include "image/raster.h"

namespace candela {

/// The mean over pixels and channels of the squared difference over the squared reference, which is
/// taken as 0.1 at least, without the worst 0.1 % of the pixels: a single bright speck would decide
/// it. The pictures are of one size.
double TrimmedRelativeError(const Image& picture, const Image& reference);

/// The largest relative difference of the means over an 8 x 8 grid of regions.
double LargestRegionDifference(const Image& a, const Image& b);

}  // namespace candela
