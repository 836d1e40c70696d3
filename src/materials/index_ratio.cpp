#include "materials/index_ratio.h"

#include <algorithm>
#include <cmath>

#include "math/wavelength.h"

namespace candela {

bool HasContrast(float a, float b) {
  return std::max(a, b) / std::min(a, b) - 1 >= kLeastContrast;
}

float FilmedRatio(float here, float beyond, bool is_from_a) {
  if (HasContrast(here, beyond)) return beyond / here;
  const bool is_larger = beyond == here ? is_from_a : beyond > here;
  return is_larger ? 1 + kLeastContrast : 1 / (1 + kLeastContrast);
}

RatioRange::RatioRange(const Medium& a, const Medium& b) : least(b.ior / a.ior), most(least) {
  if (a.dispersion.IsNone() && b.dispersion.IsNone()) return;
  constexpr int kSteps = 32;
  for (int i = 0; i <= kSteps; ++i) {
    const float part = static_cast<float>(i) / kSteps;
    const float wavelength =
        kShortestWavelength + (kLongestWavelength - kShortestWavelength) * part;
    const float ratio = b.IndexAt(wavelength) / a.IndexAt(wavelength);
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
}

float RootFrom1(float ratio) {
  return std::copysign(std::sqrt(std::abs(ratio - 1)), ratio - 1);
}

float RatioOfRoot(float root) {
  return 1 + std::copysign(root * root, root);
}

}  // namespace candela
