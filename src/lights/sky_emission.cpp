#include "lights/sky_emission.h"

#include "math/elementary.h"
#include "math/frame.h"
#include "sampling/warp.h"

namespace candela {

double SkyDiskArea(const Ball& scene) {
  return kPi * double{scene.radius} * scene.radius;
}

float SkyPositionPdf(const Ball& scene) {
  return static_cast<float>(1 / SkyDiskArea(scene));
}

EmissionSample EmitFromSky(const Ball& scene, Vec3 w, float pdf_direction, const Spectrum& radiance,
                           Vec2 u) {
  const Frame frame = Frame::FromNormal(-w);
  const Vec2 on_disk = SampleDisk(u);
  EmissionSample sample;
  sample.origin.p =
      scene.center + (frame.x * on_disk.x + frame.y * on_disk.y + frame.z) * scene.radius;
  sample.direction = w;
  sample.pdf_position = SkyPositionPdf(scene);
  sample.pdf_direction = pdf_direction;
  sample.flux = radiance * static_cast<float>(SkyDiskArea(scene) / double{pdf_direction});
  return sample;
}

}  // namespace candela
