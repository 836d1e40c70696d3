#include "integrators/distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "integrators/beers_law.h"
#include "integrators/course_rays.h"
#include "integrators/distribution_draws.h"
#include "integrators/distribution_tree.h"
#include "integrators/record_surface.h"
#include "integrators/whitted.h"

namespace candela {
namespace {

bool Mirrors(Rgb weight) {
  return Length(weight) > kLeastMirror;
}

}  // namespace

DistributionIntegrator::DistributionIntegrator(const Scene& scene, const IntegratorOptions& options)
    : scene_(scene),
      options_(options),
      times_(scene, options.seed, options.sampler),
      bounces_(options.bounces.value_or(WhittedIntegrator::kUsualBounces)) {
  for (uint32_t i = 0; i < scene.lights().size(); ++i) {
    const Light& light = *scene.lights()[i];
    if (!light.IsSurface()) {
      sharp_lights_.push_back(&light);
    } else if (options.light_samples.value_or(0) > 0 && !light.IsFoundByHitsAlone()) {
      lamps_.push_back(i);
    }
  }
  // What they send out has to stay in the cache.
  const uint32_t widest = std::max({1u, options.light_samples.value_or(0), GlossySamples(),
                                    options.indirect_samples.value_or(0)});
  together_ = std::max<size_t>(1, kMostTogether / widest);
}

bool DistributionIntegrator::IsNeeded(const Scene& scene, const IntegratorOptions& options) {
  const auto is_lamp = [](const auto& light) { return light->IsSurface(); };
  const auto has_optics = [](const auto& material) { return material->HasOptics(); };
  return scene.fog() || options.indirect_samples.value_or(0) > 0 ||
         (options.depth_of_field && !scene.camera().IsPinhole()) ||
         (options.light_samples.value_or(0) > 0 && std::ranges::any_of(scene.lights(), is_lamp)) ||
         std::ranges::any_of(scene.materials(), has_optics);
}

std::unique_ptr<Workspace> DistributionIntegrator::MakeWorkspace() const {
  return std::make_unique<Batch>();
}

void DistributionIntegrator::Trace(std::span<const SampleRequest> samples, Workspace* workspace,
                                   const SampleOutput& output) const {
  Batch* batch = static_cast<Batch*>(workspace);
  ForEachPart(samples, output, together_,
              [&](auto part, const SampleOutput& of_part) { Follow(part, batch, of_part); });
}

void DistributionIntegrator::Follow(std::span<const SampleRequest> samples, Batch* batch,
                                    const SampleOutput& output) const {
  PathQueue<TreeRay>& paths = batch->paths;
  batch->samples = samples;
  batch->sums.assign(samples.size(), Rgb());
  StartRays(batch, output);
  const bool is_pinhole = scene_.camera().IsPinhole() || !options_.depth_of_field;
  RayOrder order = is_pinhole ? RayOrder::kCoherent : RayOrder::kScattered;
  for (bool is_first = true; paths.size() > 0; is_first = false) {
    paths.FindHits(scene_, order);
    EndMisses(batch, output);
    if (is_first && output.HasLayers()) RecordSurfaces(batch, output);
    FindSurfaces(batch, output);
    for (const Light* light : sharp_lights_) AddSharpLight(*light, order, batch);
    for (const uint32_t lamp : lamps_) AddLamp(lamp, batch);
    AddOwnLight(batch, output);
    GoOn(batch);
    order = RayOrder::kScattered;
  }
  for (size_t i = 0; i < samples.size(); ++i) output.radiance[i] = Spectrum(batch->sums[i]);
}

void DistributionIntegrator::StartRays(Batch* batch, const SampleOutput& output) const {
  PathQueue<TreeRay>& paths = batch->paths;
  const std::span<const SampleRequest> samples = batch->samples;
  paths.Resize(samples.size());
  const Camera& camera = scene_.camera();
  const bool is_pinhole = camera.IsPinhole() || !options_.depth_of_field;
  const bool is_plain = is_pinhole && !times_.AreNeeded();
  if (is_plain) {
    const auto image_points = FirstOf(&batch->image_points, samples.size());
    for (size_t i = 0; i < samples.size(); ++i) image_points[i] = samples[i].image_point;
    camera.GenerateRays(image_points, paths.rays().data());
  }
  size_t started = 0;
  for (uint32_t i = 0; i < samples.size(); ++i) {
    output.Clear(i);
    const SampleRequest& request = samples[i];
    TreeRay& path = paths.states()[i];
    path = TreeRay();
    path.sample = i;
    path.index = request.index;
    path.sampler = Sampler(options_.seed, request.x, request.y, request.index, options_.sampler);
    Ray& ray = paths.rays()[i];
    if (!is_plain) {
      if (times_.AreNeeded()) path.time = times_.Draw(path.sampler);
      std::optional<Vec2> lens;
      if (!is_pinhole) lens = path.sampler.Get2D(kLensDimension);
      ray = CameraRayAt(scene_, path.time, request.image_point, lens);
    }
    if (ray.direction != Vec3()) paths.MoveTo(started++, i);
  }
  paths.Resize(started);
  batch->rays.camera += started;
}

void DistributionIntegrator::Travel(const Ray& ray, double distance, Batch* batch,
                                    const SampleOutput& output, TreeRay* path) const {
  if (path->is_inside) {
    const Spectrum left = std::isinf(distance)
                              ? EndlessTransmittance(path->absorption)
                              : Transmittance(path->absorption, static_cast<float>(distance));
    path->throughput = path->throughput * left.ToRgb();
  } else if (scene_.fog()) {
    const float left = scene_.fog()->Transmittance(ray.origin, Normalize(ray.direction), distance);
    const Rgb added = path->throughput * scene_.fog()->color() * (1 - left);
    batch->sums[path->sample] += added;
    batch->Add(*path, path->surfaces, added, output);
    path->throughput *= left;
  }
}

void DistributionIntegrator::EndMisses(Batch* batch, const SampleOutput& output) const {
  PathQueue<TreeRay>& paths = batch->paths;
  size_t left = 0;
  for (size_t i = 0; i < paths.size(); ++i) {
    if (paths.hits()[i].IsHit()) {
      paths.MoveTo(left++, i);
      continue;
    }
    TreeRay& path = paths.states()[i];
    const Ray& ray = paths.rays()[i];
    Travel(ray, std::numeric_limits<double>::infinity(), batch, output, &path);
    const Rgb background = path.throughput * scene_.background().Radiance(ray.direction).ToRgb();
    batch->Add(path, path.surfaces, background, output);
    batch->sums[path.sample] += background;
  }
  paths.Resize(left);
}

void DistributionIntegrator::RecordSurfaces(Batch* batch, const SampleOutput& output) const {
  for (size_t i = 0; i < batch->paths.size(); ++i) {
    RecordCourseSurface(scene_, batch->paths.rays()[i], batch->paths.hits()[i],
                        batch->paths.states()[i].sample, output);
  }
}

void DistributionIntegrator::FindSurfaces(Batch* batch, const SampleOutput& output) const {
  PathQueue<TreeRay>& paths = batch->paths;
  const auto shadings = FirstOf(&batch->shadings, paths.size());
  for (size_t i = 0; i < paths.size(); ++i) {
    const Ray& ray = paths.rays()[i];
    const HitRecord& hit = paths.hits()[i];
    TreeRay& path = paths.states()[i];
    const Material& material = scene_.material(hit);
    Shading& shading = shadings[i] = Shading();
    const SurfacePoint seen = scene_.ShadingAt(ray, hit);
    shading.p = seen.p;
    shading.normal = seen.n_shading;
    shading.point = scene_.SurfaceAt(ray, hit);
    shading.eye = Normalize(ray.direction);
    shading.mirrored = Mirrored(shading.eye, shading.normal);
    shading.terms = material.Phong(seen);
    shading.reflection = shading.terms.specular;
    shading.is_outside = Dot(shading.point.OutwardNormal(), shading.eye) < 0;
    if (material.HasOptics()) {
      PhongOptics& optics = shading.optics = material.Optics(seen);
      if (optics.IsTransparent()) {
        // What meets the back of a surface has come through its body, wherever it began.
        if (!shading.is_outside) {
          path.is_inside = true;
          path.absorption = optics.absorption;
        }
        const Vec3 n = Dot(shading.normal, shading.eye) > 0 ? -shading.normal : shading.normal;
        const Refraction refraction =
            Refract(shading.eye, n, shading.is_outside ? optics.ior : 1 / optics.ior);
        shading.reflection += optics.transmittance * refraction.reflectance;
        shading.refraction = optics.transmittance * (1 - refraction.reflectance);
        shading.refracted = refraction.direction;
      }
    }
    shading.reflects = path.bounces < bounces_ && Mirrors(shading.reflection);
    Travel(ray, double{hit.t} * double{Length(ray.direction)}, batch, output, &path);
  }
}

}  // namespace candela
