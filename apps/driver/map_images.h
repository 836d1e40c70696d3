#pragma once

#include <vector>

#include "driver/render_request.h"
#include "image/image_file.h"
#include "image/raster.h"
#include "integrators/first_hit.h"

namespace candela {

/// The normals of first hits as a picture: (n + 1) / 2 for formats without negative numbers, n
/// itself otherwise. Where nothing is hit it is black.
Image NormalImage(const std::vector<FirstHit>& hits, const PixelWindow& crop, ImageFormat format);

/// The distances as a grey picture: mapped from the range to 0..1 for PNG and JPEG, as they are
/// otherwise.
/// Where nothing is hit it is 0.
Image DepthImage(const std::vector<FirstHit>& hits, const PixelWindow& crop,
                 const DepthOutput& output, ImageFormat format);

}  // namespace candela
