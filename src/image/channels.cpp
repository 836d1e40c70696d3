#include "image/channels.h"

#include <algorithm>

namespace candela {
namespace {

template <class T>
Image Scaled(const Raster<T>& image, float largest) {
  Image result(image.Width(), image.Height(), image.Channels());
  const std::span<const T> from = image.Samples();
  // A true division: the product with a rounded reciprocal would not give 1 for the largest value.
  std::transform(from.begin(), from.end(), result.Samples().begin(),
                 [=](T value) { return static_cast<float>(value) / largest; });
  return result;
}

bool HasAlpha(int channels) {
  return channels == 2 || channels == 4;
}

}  // namespace

Image WithChannels(const Image& image, int channels) {
  const int old = image.Channels();
  if (channels == old) return image;
  CHECK(old >= 1 && old <= 4 && channels >= 1 && channels <= 4);
  CHECK(channels >= 3 || old <= 2);

  Image result(image.Width(), image.Height(), channels);
  const int colours = HasAlpha(channels) ? channels - 1 : channels;
  const int old_colours = HasAlpha(old) ? old - 1 : old;
  for (int y = 0; y < image.Height(); ++y) {
    for (int x = 0; x < image.Width(); ++x) {
      for (int c = 0; c < colours; ++c) {
        result.At(x, y, c) = image.At(x, y, old_colours == 1 ? 0 : c);
      }
      if (HasAlpha(channels)) {
        result.At(x, y, colours) = HasAlpha(old) ? image.At(x, y, old_colours) : 1.0f;
      }
    }
  }
  return result;
}

Image ToFloat(const ByteImage& image) {
  return Scaled(image, 255.0f);
}
Image ToFloat(const WordImage& image) {
  return Scaled(image, 65535.0f);
}

}  // namespace candela
