#include "cameras/image_plane.h"

namespace candela {

ImagePlane::Axis ImagePlane::MakeAxis(int size, PixelGrid grid) {
  if (grid == PixelGrid::kCentres) return {static_cast<float>(size), 0.5f, 1};
  // One pixel alone sits in the middle of an interval of one pixel's width.
  if (size == 1) return {1, 0.5f, 1};
  return {static_cast<float>(size - 1), 0, 1};
}

ImagePlane::ImagePlane(int width, int height, PixelGrid grid, bool stretch)
    : x_(MakeAxis(width, grid)), y_(MakeAxis(height, grid)), height_(height) {
  if (!stretch) x_.scale = x_.pixels / y_.pixels;
}

Vec2 ImagePlane::PointOf(int x, int y, Vec2 offset) const {
  // The course counts rows from the bottom; with the same operations the result is the same float.
  const auto row = static_cast<float>(height_ - 1 - y);
  return {x_.Map(static_cast<float>(x) + offset.x), y_.Map(row - offset.y)};
}

}  // namespace candela
