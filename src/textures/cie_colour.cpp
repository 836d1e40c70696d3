#include "textures/cie_colour.h"

#include "math/elementary.h"

namespace candela {
namespace {

/// A bell whose halves have widths of their own.
double Bell(double x, double middle, double width_below, double width_above) {
  const double t = (x - middle) / (x < middle ? width_below : width_above);
  return Exp(-0.5 * t * t);
}

}  // namespace

Vec3d ColourMatching(double nanometres) {
  const double l = nanometres;
  return {1.056 * Bell(l, 599.8, 37.9, 31.0) + 0.362 * Bell(l, 442.0, 16.0, 26.7) -
              0.065 * Bell(l, 501.1, 20.4, 26.2),
          0.821 * Bell(l, 568.8, 46.9, 40.5) + 0.286 * Bell(l, 530.9, 16.3, 31.1),
          1.217 * Bell(l, 437.0, 11.8, 36.0) + 0.681 * Bell(l, 459.0, 26.0, 13.8)};
}

Vec3 RgbOfXyz(Vec3d xyz) {
  return ToFloat(Vec3d{3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
                       -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
                       0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z});
}

}  // namespace candela
