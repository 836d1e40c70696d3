#include "film/pixel_sums.h"

namespace candela {

void PixelSums::Add(Rgb radiance, float sample_weight) {
  red.Add(radiance.x * sample_weight);
  green.Add(radiance.y * sample_weight);
  blue.Add(radiance.z * sample_weight);
  weight.Add(sample_weight);
}

Vec3d PixelSums::PreciseMean() const {
  const double divisor = weight.ToDouble();
  if (divisor == 0) return {};
  return {red.ToDouble() / divisor, green.ToDouble() / divisor, blue.ToDouble() / divisor};
}

}  // namespace candela
