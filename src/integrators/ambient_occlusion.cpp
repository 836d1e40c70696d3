#include "integrators/ambient_occlusion.h"

#include <algorithm>
#include <vector>

#include "geometry/spawn_ray.h"
#include "integrators/path_queue.h"
#include "integrators/path_state.h"
#include "integrators/registry.h"
#include "math/frame.h"
#include "sampling/warp.h"

namespace candela {

struct AmbientOcclusionIntegrator::Batch final : Workspace {
  struct State {
    uint32_t sample = 0;
    Sampler sampler;
  };

  PathQueue<State> paths;
  std::vector<uint32_t> samples;    ///< Those that see a surface,
  std::vector<Ray> rays_to_sky;     ///< the rays that leave it,
  std::vector<uint8_t> is_stopped;  ///< and whether something is in the way.
};

AmbientOcclusionIntegrator::AmbientOcclusionIntegrator(const Scene& scene,
                                                       const IntegratorOptions& options)
    : scene_(scene),
      distance_(options.ao_distance.value_or(Ray().t_max)),
      seed_(options.seed),
      sampler_(options.sampler),
      times_(scene, options.seed, options.sampler) {}

Result<std::unique_ptr<Integrator>> AmbientOcclusionIntegrator::Create(
    const Scene& scene, const IntegratorOptions& options) {
  return std::unique_ptr<Integrator>(std::make_unique<AmbientOcclusionIntegrator>(scene, options));
}

std::unique_ptr<Workspace> AmbientOcclusionIntegrator::MakeWorkspace() const {
  return std::make_unique<Batch>();
}

void AmbientOcclusionIntegrator::Trace(std::span<const SampleRequest> samples, Workspace* workspace,
                                       const SampleOutput& output) const {
  Batch* batch = static_cast<Batch*>(workspace);
  ForEachPart(samples, output, kMostTogether,
              [&](auto part, const SampleOutput& of_part) { Follow(part, batch, of_part); });
}

void AmbientOcclusionIntegrator::Follow(std::span<const SampleRequest> samples, Batch* batch,
                                        const SampleOutput& output) const {
  PathQueue<Batch::State>& paths = batch->paths;
  paths.Resize(samples.size());
  const bool is_pinhole = scene_.camera().IsPinhole();
  size_t started = 0;
  for (uint32_t i = 0; i < samples.size(); ++i) {
    const SampleRequest& request = samples[i];
    const Sampler sampler(seed_, request.x, request.y, request.index, sampler_);
    paths.states()[i] = {i, sampler};
    std::optional<Vec2> u;
    if (!is_pinhole) u = sampler.Get2D(kLensDimension);
    const float time = times_.AreNeeded() ? times_.Draw(sampler) : 0;
    paths.rays()[i] = CameraRayAt(scene_, time, request.image_point, u);
    output.radiance[i] = Spectrum();
    if (paths.rays()[i].direction != Vec3()) paths.MoveTo(started++, i);
  }
  paths.Resize(started);
  batch->rays.camera += started;
  paths.FindHits(scene_, is_pinhole ? RayOrder::kCoherent : RayOrder::kScattered);

  batch->samples.clear();
  batch->rays_to_sky.clear();
  for (size_t i = 0; i < paths.size(); ++i) {
    const auto& [sample, sampler] = paths.states()[i];
    const Ray& ray = paths.rays()[i];
    const HitRecord& hit = paths.hits()[i];
    if (!hit.IsHit()) {
      output.radiance[sample] = scene_.background().Radiance(ray.direction);
      continue;
    }
    const SurfacePoint point = scene_.SurfaceAt(ray, hit);
    const bool is_behind = Dot(point.n_geometric, ray.direction) > 0;
    const Vec3 outward = is_behind ? -point.n_geometric : point.n_geometric;
    const Vec3 n = Dot(point.n_shading, outward) < 0 ? -point.n_shading : point.n_shading;
    const Vec2 u = sampler.Get2D(BounceDimension(0) + kDirection);
    const Vec3 w = Frame::FromNormal(n).ToWorld(SampleCosineHemisphere(u));
    if (!(Dot(w, outward) > 0)) continue;  // The surface itself is in the way.
    Ray to_sky = SpawnRay(point, w);
    to_sky.t_max = distance_;
    to_sky.time = ray.time;
    to_sky.mask = kShadowRay;
    batch->samples.push_back(sample);
    batch->rays_to_sky.push_back(to_sky);
  }

  const size_t count = batch->rays_to_sky.size();
  batch->rays.shadow += count;
  scene_.Occluded(RayOrder::kScattered, batch->rays_to_sky, FirstOf(&batch->is_stopped, count));
  for (size_t i = 0; i < count; ++i) {
    if (batch->is_stopped[i]) continue;
    const float left = scene_.HasHoles() ? scene_.Transparency(batch->rays_to_sky[i]) : 1;
    output.radiance[batch->samples[i]] = Spectrum(left);
  }
}

}  // namespace candela
