#pragma once

#include "image/raster.h"

namespace candela {

/// The same picture with another number of channels, both from 1 to 4: grey is repeated in red,
/// green and blue, a missing alpha is 1, a surplus alpha is dropped. Colour is not turned into
/// grey: `channels` of 1 or 2 needs an image of 1 or 2.
Image WithChannels(const Image& image, int channels);

/// Values divided by the largest one of the type, so that they go from 0 to 1. No gamma.
Image ToFloat(const ByteImage& image);
Image ToFloat(const WordImage& image);

}  // namespace candela
