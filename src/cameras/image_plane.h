#pragma once

#include "math/vec.h"

namespace candela {

/// Where on the image plane the pixels of a picture lie.
enum class PixelGrid {
  kCorners,  ///< The course's: the centres of corner pixels lie exactly on the edges, -1 and 1.
  kCentres,  ///< The picture's outer edges lie there; pixel centres are half a pixel inside.
};

/// Maps positions in a picture to the camera's image plane.
class ImagePlane {
 public:
  /// `stretch` fills the field of view in both directions, so that pixels of pictures that are not
  /// square are not square either, as in the course; otherwise the field of view is the vertical
  /// one.
  ImagePlane(int width, int height, PixelGrid grid, bool stretch);

  /// The image point of pixel (x, y), y counted from the top, moved by `offset` pixels from the
  /// pixel's centre, its y counted downwards. A side of one pixel maps to 0.
  Vec2 PointOf(int x, int y, Vec2 offset) const {
    // The course counts rows from the bottom; with the same operations the result is the same
    // float.
    const auto row = static_cast<float>(height_ - 1 - y);
    return {x_.Map(static_cast<float>(x) + offset.x), y_.Map(row - offset.y)};
  }

  /// The distance between neighbouring pixels in a column.
  float Spacing() const { return 2 / y_.pixels * y_.scale; }

  /// The inverse: the position in the picture of an image point, where pixel centres have whole
  /// numbers and y is counted downwards from that of the top row. It may lie outside.
  Vec2 PositionOf(Vec2 image_point) const {
    return {x_.Invert(image_point.x), static_cast<float>(height_ - 1) - y_.Invert(image_point.y)};
  }

  /// How many pixels there are to a unit of area of the image plane.
  float PixelsPerArea() const { return x_.pixels / (2 * x_.scale) * (y_.pixels / (2 * y_.scale)); }

 private:
  struct Axis {
    float pixels;  ///< Between -1 and 1.
    float first;   ///< The position of the first pixel's centre, counted from -1, in pixels.
    float scale;   ///< From [-1, 1] to the image plane.
    float Map(float pixel) const { return (2 * (pixel + first) / pixels - 1) * scale; }
    float Invert(float point) const { return (point / scale + 1) * pixels / 2 - first; }
  };
  static Axis MakeAxis(int size, PixelGrid grid);

  Axis x_, y_;
  int height_;
};

}  // namespace candela
