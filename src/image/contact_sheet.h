#pragma once

#include <span>

#include "image/raster.h"
#include "math/spectrum.h"

namespace candela {

/// A smaller copy: each pixel is the mean of the area of `image` that it covers, pixels at the edge
/// of that area counted by the part inside. The new sides are from 1 to the old ones.
Image ShrinkImage(const Image& image, int width, int height);

/// How pictures stand on a sheet: cells of one size in rows, with a margin around each. Lengths are
/// pixels.
struct SheetLayout {
  int columns = 4;
  int cell_width = 256;
  int cell_height = 256;
  int margin = 8;
  Rgb background = {1, 1, 1};
};

/// Puts pictures (1 to 4 channels; alpha is left out) on a sheet of three channels, from left to
/// right and top to bottom. Each is shrunk to fit its cell and centred in it; smaller ones are not
/// enlarged.
Image MakeContactSheet(std::span<const Image> images, const SheetLayout& layout);

}  // namespace candela
