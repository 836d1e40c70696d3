#include "integrators/path_lights.h"

#include <algorithm>

namespace candela {
namespace {

/// Lights of a scene, as the path integrator numbers them.
std::vector<const Light*> LightsOf(const Scene& scene, const EnvironmentLight* environment) {
  std::vector<const Light*> lights;
  for (const auto& light : scene.lights()) lights.push_back(light.get());
  if (environment) lights.push_back(environment);
  return lights;
}

/// Those to choose from when a light is to be sampled: the others are found by rays alone.
std::vector<const Light*> OnlyPoints(std::vector<const Light*> lights) {
  struct Dark final : Light {
    LightKind Kind() const override { return LightKind::kSurface; }
    LightSample SampleIncident(Vec3) const override { return {{}, {}, 0, 0}; }
    LightReach Reach() const override { return {}; }
    EmissionSample SampleEmission(const Ball&, Vec2, Vec2) const override { return {}; }
    EmissionPdf PdfEmission(const Ball&, const SurfacePoint&, Vec3) const override {
      return {0, 0};
    }
    float Power(const Ball&) const override { return 0; }
  };
  static const Dark kDark;
  for (const Light*& light : lights) {
    if (light->Kind() != LightKind::kPoint) light = &kDark;
  }
  return lights;
}

float SizeOf(const Scene& scene) {
  const Bounds3 bounds = scene.Bounds();
  const float size = bounds.IsEmpty() ? 1 : Length(bounds.Extent()) / 2;
  return std::clamp(size, 1e-10f, 1e10f);
}

}  // namespace

std::unique_ptr<const EnvironmentLight> EnvironmentOf(const Background& background) {
  if (background.environment) return std::make_unique<EnvironmentLight>(*background.environment);
  if (background.cube_map) return std::make_unique<EnvironmentLight>(*background.cube_map);
  return nullptr;
}

PathLights::PathLights(const Scene& scene, const PathTechniques& techniques)
    : scene_(scene),
      techniques_(techniques),
      environment_(EnvironmentOf(scene.background())),
      lights_(LightsOf(scene, environment_.get())),
      picker_(techniques.next_event ? lights_ : OnlyPoints(lights_), SizeOf(scene),
              techniques.light_choice) {
  for (uint32_t i = 0; i < scene.lights().size(); ++i) {
    if (lights_[i]->Kind() == LightKind::kSky) suns_.push_back(i);
  }
}

PathLights::Draw PathLights::Sample(const Receiver& to, float u_choice, Vec2 u_point) const {
  const auto [index, choice] = picker_.Choose(to, u_choice);
  const Light& light = *lights_[index];
  const uint32_t group =
      index < scene_.lights().size() ? scene_.GroupOfLight(index) : scene_.GroupOfBackground();
  return {light.SampleIncident(to.p, u_point), choice, group, light.Kind() != LightKind::kPoint};
}

Spectrum PathLights::FromBackground(const PathState& path, Vec3 direction) const {
  const Spectrum radiance = scene_.background().Radiance(direction);
  if (!environment_) return radiance;
  const auto index = static_cast<uint32_t>(lights_.size() - 1);
  return radiance * Spectrum(WeightOfFound(path, index, {}, direction));
}

Spectrum PathLights::FromSun(const PathState& path, Vec3 direction, uint32_t sun) const {
  const Spectrum light = lights_[sun]->Emitted({}, -direction);
  return light.IsBlack() ? light : light * WeightOfFound(path, sun, {}, direction);
}

Spectrum PathLights::FromSurface(const PathState& path, const SurfacePoint& point, Vec3 wo,
                                 uint32_t light) const {
  const Spectrum emitted = lights_[light]->Emitted(point, wo);
  if (emitted.IsBlack()) return {};
  return emitted * WeightOfFound(path, light, point, -wo);
}

/// How much of a light counts that a ray along `w` has found, where it could have been sampled too.
float PathLights::WeightOfFound(const PathState& path, uint32_t light, const SurfacePoint& point,
                                Vec3 w) const {
  if (path.pdf == 0 || !techniques_.next_event) return 1;
  const float choice = picker_.Probability(path.receiver, light);
  if (choice == 0) return 1;
  return Weight(path.pdf, choice * lights_[light]->PdfIncident(path.receiver.p, point, w));
}

float PathLights::Weight(float pdf, float other_pdf) const {
  if (other_pdf == 0) return 1;
  const float ratio = other_pdf / pdf;
  const bool is_power = techniques_.weights == PathTechniques::Weights::kPowerHeuristic;
  return 1 / (1 + (is_power ? ratio * ratio : ratio));
}

}  // namespace candela
