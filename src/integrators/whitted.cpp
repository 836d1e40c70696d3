#include "integrators/whitted.h"

#include <algorithm>

#include "base/make_at.h"
#include "integrators/course_rays.h"
#include "integrators/distribution.h"
#include "integrators/path_queue.h"
#include "integrators/ray_story.h"
#include "integrators/record_surface.h"
#include "integrators/registry.h"

namespace candela {
namespace {

/// A sample on its way.
struct Path {
  uint32_t sample = 0;  ///< Its place in the list.
  Rgb radiance{};
  Rgb throughput{1, 1, 1};
};

/// What its lights have to know of the surface that a path has met, and their sum so far.
struct Shading {
  Vec3 p, normal;
  Vec3 eye;       ///< The unit direction that the ray came along,
  Vec3 mirrored;  ///< and that in which it goes on.
  PhongTerms terms;
  Rgb light;
};

}  // namespace

/// What is known of samples that are followed together. Entries of all lists belong to the paths at
/// the same place; there may be more of them.
struct WhittedIntegrator::Batch final : Workspace {
  PathQueue<Path> paths;
  std::vector<Vec2> image_points;
  std::vector<Shading> shadings;
  // With shadows, of the light in work:
  std::vector<LightSample> light_samples;  ///< what comes from it if nothing is in the way,
  std::vector<Ray> shadow_rays;            ///< the rays towards it,
  std::vector<uint8_t> is_shadowed;        ///< and whether something is in their way.
};

WhittedIntegrator::WhittedIntegrator(const Scene& scene, uint32_t bounces, bool shadows,
                                     uint32_t seed, SamplerType sampler)
    : scene_(scene), bounces_(bounces), shadows_(shadows), times_(scene, seed, sampler) {
  for (const auto& light : scene.lights()) {
    if (!light->IsSurface()) sharp_lights_.push_back(light.get());
  }
}

Result<std::unique_ptr<Integrator>> WhittedIntegrator::Create(const Scene& scene,
                                                              const IntegratorOptions& options) {
  if (DistributionIntegrator::IsNeeded(scene, options)) {
    return std::unique_ptr<Integrator>(std::make_unique<DistributionIntegrator>(scene, options));
  }
  return std::unique_ptr<Integrator>(
      std::make_unique<WhittedIntegrator>(scene, options.bounces.value_or(kUsualBounces),
                                          options.shadows, options.seed, options.sampler));
}

std::unique_ptr<Workspace> WhittedIntegrator::MakeWorkspace() const {
  return std::make_unique<Batch>();
}

void WhittedIntegrator::Trace(std::span<const SampleRequest> samples, Workspace* workspace,
                              const SampleOutput& output) const {
  NoStory nobody;
  Batch* batch = static_cast<Batch*>(workspace);
  ForEachPart(samples, output, kMostTogether, [&](auto part, const SampleOutput& of_part) {
    Follow(part, batch, of_part, &nobody);
  });
}

std::vector<std::string> WhittedIntegrator::Explain(const SampleRequest& sample) const {
  RayStory story(scene_);
  Batch batch;
  Spectrum radiance;
  Follow({&sample, 1}, &batch, {{&radiance, 1}}, &story);
  story.OnResult(radiance.ToRgb());
  return story.TakeLines();
}

template <class Observer>
void WhittedIntegrator::Follow(std::span<const SampleRequest> samples, Batch* batch,
                               const SampleOutput& output, Observer* observer) const {
  PathQueue<Path>& paths = batch->paths;
  paths.Resize(samples.size());
  const auto image_points = FirstOf(&batch->image_points, samples.size());
  for (size_t i = 0; i < samples.size(); ++i) image_points[i] = samples[i].image_point;
  bool all_see = false;
  if (times_.AreNeeded()) {
    for (size_t i = 0; i < samples.size(); ++i) {
      paths.rays()[i] = CameraRayAt(scene_, times_.Draw(samples[i]), image_points[i]);
    }
  } else {
    all_see = scene_.camera().GenerateRays(image_points, paths.rays().data());
  }
  size_t started = 0;
  for (uint32_t i = 0; i < samples.size(); ++i) {
    output.ClearLayers(i);
    if (!all_see && paths.rays()[i].direction == Vec3()) {
      output.radiance[i] = Spectrum();
      continue;
    }
    paths.states()[i] = {i};
    paths.MoveTo(started++, i);
  }
  paths.Resize(started);
  batch->rays.camera += started;

  RayOrder order = RayOrder::kCoherent;
  for (uint32_t bounce = 0; paths.size() > 0; ++bounce) {
    paths.FindHits(scene_, order);
    EndMisses(bounce, batch, output, observer);
    if (bounce == 0 && output.HasLayers()) RecordSurfaces(batch, output);
    FindSurfaces(batch, observer);
    for (const Light* light : sharp_lights_) {
      if (shadows_) FindShadows(*light, order, batch);
      AddLight(*light, batch, observer);
    }
    Reflect(bounce, batch, output, observer);
    order = RayOrder::kScattered;
  }
}

template <class Observer>
void WhittedIntegrator::EndMisses(uint32_t bounce, Batch* batch, const SampleOutput& output,
                                  Observer* observer) const {
  PathQueue<Path>& paths = batch->paths;
  size_t left = 0;
  for (size_t i = 0; i < paths.size(); ++i) {
    if (paths.hits()[i].IsHit()) {
      paths.MoveTo(left++, i);
      continue;
    }
    const Path& path = paths.states()[i];
    const Rgb background = scene_.background().Radiance(paths.rays()[i].direction).ToRgb();
    observer->OnMiss(paths.rays()[i], background);
    if (output.HasLayers()) {
      output.layers[path.sample].AddLight(bounce, path.throughput * background);
    }
    output.radiance[path.sample] = Spectrum(path.radiance + path.throughput * background);
  }
  paths.Resize(left);
}

void WhittedIntegrator::RecordSurfaces(Batch* batch, const SampleOutput& output) const {
  for (size_t i = 0; i < batch->paths.size(); ++i) {
    RecordCourseSurface(scene_, batch->paths.rays()[i], batch->paths.hits()[i],
                        batch->paths.states()[i].sample, output);
  }
}

template <class Observer>
void WhittedIntegrator::FindSurfaces(Batch* batch, Observer* observer) const {
  PathQueue<Path>& paths = batch->paths;
  const auto shadings = FirstOf(&batch->shadings, paths.size());
  for (size_t i = 0; i < paths.size(); ++i) {
    const Ray& ray = paths.rays()[i];
    const HitRecord& hit = paths.hits()[i];
    const SurfacePoint surface = scene_.ShadingAt(ray, hit);
    Shading& shading = shadings[i];
    shading.p = surface.p;
    shading.normal = surface.n_shading;
    shading.eye = Normalize(ray.direction);
    shading.mirrored = Mirrored(shading.eye, surface.n_shading);
    MakeAt(&shading.terms, [&] { return scene_.material(hit).Phong(surface); });
    shading.light = Rgb();
    observer->OnHit(ray, hit, surface.n_shading, shading.terms);
  }
}

void WhittedIntegrator::FindShadows(const Light& light, RayOrder order, Batch* batch) const {
  const size_t count = batch->paths.size();
  const auto rays = FirstOf(&batch->shadow_rays, count);
  const auto samples = FirstOf(&batch->light_samples, count);
  for (size_t i = 0; i < count; ++i) {
    const Vec3 p = batch->shadings[i].p;
    LightSample& sample = samples[i];
    MakeAt(&sample, [&] { return light.SampleIncident(p); });
    StartRay(p, sample.direction, kWholeShadowRay, ShadowLimit(sample.distance),
             batch->paths.rays()[i].time, &rays[i]);
  }
  batch->rays.shadow += count;
  scene_.Occluded(order, rays, FirstOf(&batch->is_shadowed, count));
}

template <class Observer>
void WhittedIntegrator::AddLight(const Light& light, Batch* batch, Observer* observer) const {
  for (size_t i = 0; i < batch->paths.size(); ++i) {
    Shading& shading = batch->shadings[i];
    const LightSample sample = shadows_ ? batch->light_samples[i] : light.SampleIncident(shading.p);
    const bool is_shadowed = shadows_ && batch->is_shadowed[i] != 0;
    Rgb diffuse, specular;
    if (!is_shadowed) {
      const Rgb intensity = sample.radiance.ToRgb();
      const float cosine = std::max(0.0f, Dot(shading.normal, sample.direction));
      diffuse = intensity * shading.terms.diffuse * cosine;
      if (shading.terms.specular != Rgb()) {
        specular = intensity * shading.terms.specular *
                   Highlight(Dot(shading.mirrored, sample.direction), shading.terms.shininess);
      }
      shading.light += diffuse + specular;
    }
    observer->OnLight(light, sample, is_shadowed, diffuse, specular);
  }
}

template <class Observer>
void WhittedIntegrator::Reflect(uint32_t bounce, Batch* batch, const SampleOutput& output,
                                Observer* observer) const {
  PathQueue<Path>& paths = batch->paths;
  size_t left = 0;
  for (size_t i = 0; i < paths.size(); ++i) {
    const Shading& shading = batch->shadings[i];
    const Rgb specular = shading.terms.specular;
    const Rgb ambient = scene_.background().ambient_light * shading.terms.ambient;
    observer->OnAmbient(ambient);
    Rgb local = shading.light + ambient;
    const Path& before = paths.states()[i];
    const uint32_t lamp = scene_.objects()[paths.hits()[i].object].light;
    if (output.HasLayers()) {
      output.layers[before.sample].AddLight(bounce + 1, before.throughput * local);
    }
    if (lamp != SceneObject::kNoLight) {
      SurfacePoint surface;
      surface.p = shading.p;
      surface.n_shading = shading.normal;
      const Rgb emitted = scene_.lights()[lamp]->Emitted(surface, -shading.eye).ToRgb();
      observer->OnEmission(emitted);
      local += emitted;
      if (output.HasLayers()) {
        output.layers[before.sample].AddLight(bounce, before.throughput * emitted);
      }
    }
    Path path = before;
    path.radiance += path.throughput * local;
    path.throughput = path.throughput * specular;

    const char* end = nullptr;
    if (!(Length(specular) > kLeastMirror)) {
      end = "does not mirror";
    } else if (bounce == bounces_) {
      end = "no bounces are left";
    } else if (path.throughput == Rgb()) {
      // Rounded to 0 after many mirrors: nothing can be added any more.
      end = "reflects, but too little to count";
    }
    if (end) {
      observer->OnEnd(end);
      output.radiance[path.sample] = Spectrum(path.radiance);
      continue;
    }
    observer->OnReflection(specular);
    const Vec3 reflected = Mirrored(paths.rays()[i].direction, shading.normal);
    paths.states()[left] = path;
    StartRay(shading.p, reflected, kReflectionRay, Ray().t_max, paths.rays()[i].time,
             &paths.rays()[left++]);
  }
  paths.Resize(left);
  batch->rays.reflection += left;
}

}  // namespace candela
