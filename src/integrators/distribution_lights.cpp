// What lights do to the surfaces that rays have met.

#include <algorithm>

#include "geometry/spawn_ray.h"
#include "integrators/course_rays.h"
#include "integrators/distribution.h"
#include "integrators/distribution_draws.h"
#include "integrators/distribution_tree.h"
#include "math/elementary.h"

namespace candela {

// As the course does it.
void DistributionIntegrator::AddSharpLight(const Light& light, RayOrder order, Batch* batch) const {
  const size_t count = batch->paths.size();
  const auto samples = FirstOf(&batch->light_samples, count);
  for (size_t i = 0; i < count; ++i) {
    samples[i] = light.SampleIncident(batch->shadings[i].p);
  }
  const auto is_shadowed = FirstOf(&batch->is_shadowed, count);
  if (options_.shadows) {
    const auto rays = FirstOf(&batch->shadow_rays, count);
    for (size_t i = 0; i < count; ++i) {
      StartRay(batch->shadings[i].p, samples[i].direction, kWholeShadowRay,
               ShadowLimit(samples[i].distance), batch->paths.states()[i].time, &rays[i]);
    }
    batch->rays.shadow += count;
    scene_.Occluded(order, rays, is_shadowed);
  } else {
    std::ranges::fill(is_shadowed, uint8_t{0});
  }
  for (size_t i = 0; i < count; ++i) {
    if (is_shadowed[i] != 0) continue;
    Shading& shading = batch->shadings[i];
    const Rgb intensity = samples[i].radiance.ToRgb();
    const float cosine = std::max(0.0f, Dot(shading.normal, samples[i].direction));
    const Rgb diffuse = intensity * shading.terms.diffuse * cosine;
    Rgb specular;
    if (shading.terms.specular != Rgb()) {
      specular = intensity * shading.terms.specular *
                 Highlight(Dot(shading.mirrored, samples[i].direction), shading.terms.shininess);
    }
    shading.light += diffuse + specular;
  }
}

// A lamp is as many point lights as there are rays to it, each with its part of the irradiance,
// which a diffuse surface throws back as light does: divided by pi, so that the same comes from
// gathering what shines. Where a mirrored ray goes on it shows the lamp itself, not its highlight.
void DistributionIntegrator::AddLamp(uint32_t number, Batch* batch) const {
  const Light& light = *scene_.lights()[number];
  const uint32_t branch = static_cast<uint32_t>(Branch::kFirstLight) + number;
  batch->lamp_lights.clear();
  batch->shadow_rays.clear();
  for (size_t i = 0; i < batch->paths.size(); ++i) {
    const TreeRay& path = batch->paths.states()[i];
    const Shading& shading = batch->shadings[i];
    const Rgb specular = shading.reflects ? Rgb() : shading.terms.specular;
    if (shading.terms.diffuse == Rgb() && specular == Rgb()) continue;
    const uint32_t count = path.is_one_of_many ? 1 : *options_.light_samples;
    for (uint32_t k = 0; k < count; ++k) {
      const TreeRay drawn = ChildOf(path, branch, count, k, *batch);
      const LightSample sample =
          light.SampleIncident(shading.point.p, drawn.sampler.Get2D(DimensionOf(drawn.name)));
      if (sample.pdf == 0 || sample.radiance.IsBlack()) continue;
      const Rgb intensity = sample.radiance.ToRgb() /
                            (static_cast<float>(kPi) * sample.pdf * static_cast<float>(count));
      Rgb scattered = shading.terms.diffuse * std::max(0.0f, Dot(shading.normal, sample.direction));
      if (specular != Rgb()) {
        scattered +=
            specular * Highlight(Dot(shading.mirrored, sample.direction), shading.terms.shininess);
      }
      if (scattered == Rgb()) continue;
      batch->lamp_lights.push_back({i, intensity * scattered});
      if (!options_.shadows) continue;
      Ray ray = SpawnRay(shading.point, sample.direction);
      ray.t_max = sample.distance;
      ray.mask = kWholeShadowRay;
      ray.time = path.time;
      batch->shadow_rays.push_back(ray);
    }
  }
  const size_t count = batch->lamp_lights.size();
  if (options_.shadows) {
    batch->rays.shadow += count;
    scene_.Occluded(RayOrder::kScattered, batch->shadow_rays, FirstOf(&batch->is_shadowed, count));
  }
  for (size_t i = 0; i < count; ++i) {
    if (options_.shadows && batch->is_shadowed[i] != 0) continue;
    batch->shadings[batch->lamp_lights[i].place].light += batch->lamp_lights[i].light;
  }
}

bool DistributionIntegrator::Gathers(const TreeRay& path, const Shading& shading) const {
  return options_.indirect_samples.value_or(0) > 0 && !path.is_one_of_many &&
         shading.terms.diffuse != Rgb();
}

// Of the light that is gathered the part that comes from lamps is left out where these are sampled.
Rgb DistributionIntegrator::Emitted(uint32_t number, const TreeRay& path,
                                    const Shading& shading) const {
  const Light& light = *scene_.lights()[number];
  const bool is_sampled = path.is_gathered && std::ranges::count(lamps_, number) > 0 &&
                          light.PdfIncident(path.gathered_from, shading.point, shading.eye) > 0;
  if (is_sampled) return {};
  SurfacePoint surface;
  surface.p = shading.p;
  surface.n_shading = shading.normal;
  return light.Emitted(surface, -shading.eye).ToRgb();
}

void DistributionIntegrator::AddOwnLight(Batch* batch, const SampleOutput& output) const {
  PathQueue<TreeRay>& paths = batch->paths;
  for (size_t i = 0; i < paths.size(); ++i) {
    const TreeRay& path = paths.states()[i];
    const Shading& shading = batch->shadings[i];
    // The ambient light stands for what is gathered.
    const bool has_ambient = !Gathers(path, shading);
    const Rgb ambient =
        has_ambient ? scene_.background().ambient_light * shading.terms.ambient : Rgb();
    Rgb local = shading.light + ambient;
    batch->Add(path, path.surfaces + 1, path.throughput * local, output);
    const uint32_t lamp = scene_.objects()[paths.hits()[i].object].light;
    if (lamp != SceneObject::kNoLight) {
      const Rgb emitted = Emitted(lamp, path, shading);
      local += emitted;
      batch->Add(path, path.surfaces, path.throughput * emitted, output);
    }
    batch->sums[path.sample] += path.throughput * local;
  }
}

}  // namespace candela
