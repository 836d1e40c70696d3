#pragma once

#include <cstdint>
#include <string>

#include "cameras/image_plane.h"

namespace candela {

/// A part of a picture: columns [x0, x1) and rows [y0, y1), counted from the top left.
struct CropWindow {
  uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  uint32_t Width() const { return x1 - x0; }
  uint32_t Height() const { return y1 - y0; }
  uint64_t PixelCount() const { return uint64_t{Width()} * Height(); }
};

/// Where in a pixel the samples lie and how they are weighed.
enum class SamplePattern {
  kCentre,      ///< All at the pixel's position.
  kStrata,      ///< The course's `-jitter`: 4 x 4 strata, averaged.
  kStrataTent,  ///< The same samples, weighed with a tent of radius 1.
  kFilter,      ///< Any number, drawn from a pixel filter.
};

/// What a picture is made of, apart from the scene and the integrator.
struct RenderOptions {
  uint32_t width = 800, height = 800;
  CropWindow crop{0, 0, 800, 800};  ///< What is rendered of it; the pixels are those of the whole.
  PixelGrid grid = PixelGrid::kCorners;
  bool stretch = false;

  SamplePattern pattern = SamplePattern::kCentre;
  std::string filter = "box";  ///< For `kFilter`: a name of `PixelFilterEntries()`.
  uint32_t samples = 1;        ///< Per pixel; 16 for the patterns of strata.
  uint64_t seed = 0;
  uint32_t tile_size =
      32;  ///< Side of the blocks that threads take; changes nothing in the picture.
};

}  // namespace candela
