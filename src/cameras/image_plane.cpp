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

}  // namespace candela
