#include "driver/map_images.h"

namespace candela {
namespace {

/// A picture whose pixels are what `value` gives for a hit, and black for a miss.
template <class Value>
Image MapHits(const std::vector<FirstHit>& hits, const PixelWindow& crop, Value value) {
  Image image(crop.Width(), crop.Height(), 3);
  float* out = image.Samples().data();
  for (const FirstHit& hit : hits) {
    const Rgb color = hit.is_hit ? value(hit) : Rgb();
    *out++ = color.x;
    *out++ = color.y;
    *out++ = color.z;
  }
  return image;
}

}  // namespace

Image NormalImage(const std::vector<FirstHit>& hits, const PixelWindow& crop, ImageFormat format) {
  const bool has_negative = format == ImageFormat::kExr || format == ImageFormat::kPfm;
  return MapHits(hits, crop, [has_negative](const FirstHit& hit) {
    return has_negative ? hit.normal : (hit.normal + Vec3{1, 1, 1}) / 2.0f;
  });
}

Image DepthImage(const std::vector<FirstHit>& hits, const PixelWindow& crop,
                 const DepthOutput& output, ImageFormat format) {
  const bool is_mapped = IsForDisplays(format);
  return MapHits(hits, crop, [&](const FirstHit& hit) {
    const float value =
        is_mapped ? (hit.depth - output.min) / (output.max - output.min) : hit.depth;
    return Rgb{value, value, value};
  });
}

}  // namespace candela
