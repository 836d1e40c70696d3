#include "textures/black_body.h"

#include "math/planck.h"
#include "textures/cie_colour.h"

namespace candela {
namespace {

/// The second row of the inverse of the matrix of `RgbOfXyz`.
double Luminance(Rgb colour) {
  return 0.2126729 * double{colour.x} + 0.7151522 * double{colour.y} + 0.0721750 * double{colour.z};
}

}  // namespace

Rgb BlackBodyColour(double kelvin) {
  constexpr int kFirst = 360, kLast = 830, kStep = 5;  // In nanometres.
  Vec3d xyz;
  for (int nanometres = kFirst; nanometres <= kLast; nanometres += kStep) {
    xyz = xyz + ColourMatching(nanometres) * PlanckRadiance(nanometres * 1e-9, kelvin);
  }
  const Rgb shown = Max(RgbOfXyz(xyz / xyz.y), Rgb());
  return shown / static_cast<float>(Luminance(shown));
}

}  // namespace candela
