#include "textures/mip_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "math/elementary.h"

namespace candela {
namespace {

/// Half as large in each direction. Of an odd number of texels the last one goes into the last mean
/// alone or as the third: each counts by its area.
Image Halved(const Image& image) {
  const int width = std::max(1, image.Width() / 2), height = std::max(1, image.Height() / 2);
  Image half(width, height, 3);
  const auto first = [](int i, int size, int from) {
    return static_cast<int>(int64_t{i} * from / size);
  };
  for (int y = 0; y < height; ++y) {
    const int y0 = first(y, height, image.Height()), y1 = first(y + 1, height, image.Height());
    for (int x = 0; x < width; ++x) {
      const int x0 = first(x, width, image.Width()), x1 = first(x + 1, width, image.Width());
      for (int c = 0; c < 3; ++c) {
        float sum = 0;
        for (int j = y0; j < y1; ++j) {
          for (int i = x0; i < x1; ++i) sum += image.At(i, j, c);
        }
        half.At(x, y, c) = sum / static_cast<float>(int64_t{y1 - y0} * (x1 - x0));
      }
    }
  }
  return half;
}

/// The fraction of a coordinate, in [0, 1); 0 for what is no number.
float Fraction(float x) {
  const float fraction = x - std::floor(x);
  return fraction >= 0 && fraction < 1 ? fraction : 0;
}

}  // namespace

MipMap::MipMap(Image image, Wrap wrap) : wrap_(wrap) {
  levels_.push_back(std::move(image));
  while (levels_.back().Width() > 1 || levels_.back().Height() > 1) {
    levels_.push_back(Halved(levels_.back()));
  }
}

int MipMap::Wrapped(int index, int size) const {
  if (index >= 0 && index < size) return index;
  if (wrap_ == Wrap::kRepeat) return index < 0 ? size - 1 : 0;
  return std::clamp(index, 0, size - 1);  // The mirrored neighbour of an edge is the edge itself.
}

Rgb MipMap::Bilinear(const Image& level, Vec2 uv) const {
  const float x = uv.x * static_cast<float>(level.Width()) - 0.5f;
  const float y = (1 - uv.y) * static_cast<float>(level.Height()) - 0.5f;
  const float left = std::floor(x), top = std::floor(y);
  const float fx = x - left, fy = y - top;
  const auto texel = [&](int column, int row) {
    const float* t = &level.At(Wrapped(static_cast<int>(left) + column, level.Width()),
                               Wrapped(static_cast<int>(top) + row, level.Height()));
    return Rgb{t[0], t[1], t[2]};
  };
  return (texel(0, 0) * (1 - fx) + texel(1, 0) * fx) * (1 - fy) +
         (texel(0, 1) * (1 - fx) + texel(1, 1) * fx) * fy;
}

Rgb MipMap::Lookup(Vec2 uv, float width) const {
  const auto place = [this](float x) {
    if (wrap_ == Wrap::kRepeat) return Fraction(x);
    if (wrap_ == Wrap::kClamp) return x >= 0 ? std::min(x, 1.0f) : 0.0f;
    const float t = 2 * Fraction(x / 2);
    return t <= 1 ? t : 2 - t;
  };
  const Vec2 at{place(uv.x), place(uv.y)};
  const float texels = width * static_cast<float>(std::max(Width(), Height()));
  if (!(texels > 1)) return Bilinear(levels_[0], at);
  const float level = Log2(texels);
  const int last = LevelCount() - 1;
  if (!(level < static_cast<float>(last))) return Bilinear(levels_.back(), at);
  const int index = static_cast<int>(level);
  const float t = level - static_cast<float>(index);
  return Bilinear(levels_[static_cast<size_t>(index)], at) * (1 - t) +
         Bilinear(levels_[static_cast<size_t>(index) + 1], at) * t;
}

uint64_t MipMap::MemoryBytes() const {
  uint64_t bytes = 0;
  for (const Image& level : levels_) bytes += level.Samples().size_bytes();
  return bytes;
}

}  // namespace candela
