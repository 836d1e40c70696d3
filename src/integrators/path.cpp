#include "integrators/path.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.h"
#include "geometry/spawn_ray.h"
#include "integrators/beers_law.h"
#include "integrators/bounce_numbers.h"
#include "integrators/path_queue.h"
#include "integrators/path_vertex.h"
#include "integrators/record_surface.h"
#include "integrators/registry.h"
#include "sampling/sampler.h"

namespace candela {
namespace {

// Bounces that every path may take, and by how much its survival exceeds its share of the power:
// measured over the scenes of bench/render, where earlier ends cost more in noise than they save.
constexpr uint32_t kRouletteAfter = 2;
constexpr float kSurvivalOfShare = 2;
// From this bounce on no path is sure to survive, so that even those without any loss end.
constexpr uint32_t kUncertainAfter = 4;

}  // namespace

/// What is known of samples that are followed together.
struct PathIntegrator::Batch final : Workspace {
  /// What comes from a sampled light if nothing is in the way.
  struct Contribution {
    uint32_t sample, times_scattered, group;
    Spectrum value;
  };

  PathQueue<uint32_t> paths;      ///< By the number of their sample,
  std::vector<PathState> states;  ///< by which these are found: they stay where they are.
  std::vector<Sampler> samplers;  ///< Of the paths in the queue, which come first,
  BounceNumbersOfMany numbers;    ///< and what they give for the bounce that these are at.
  std::vector<Vec2> image_points;
  std::vector<Contribution> contributions;
  std::vector<Ray> shadow_rays;      ///< That each of them depends on,
  std::vector<uint8_t> is_shadowed;  ///< and whether something is in the way.
};

PathIntegrator::PathIntegrator(const Scene& scene, const IntegratorOptions& options,
                               const PathTechniques& techniques)
    : scene_(scene),
      lights_(scene, techniques),
      media_at_camera_(MediaAround(scene, scene.camera().GenerateRay({0, 0}).origin, 0)),
      starts_in_one_place_((scene.camera().IsInOnePlace() && !scene.IsMoving()) ||
                           scene.interiors().empty()),
      limits_(options),
      seed_(options.seed),
      sampler_(options.sampler),
      times_(scene, options.seed, options.sampler),
      has_roulette_(techniques.roulette),
      has_lift_(techniques.lift),
      beyond_light_paths_(techniques.beyond_light_paths) {}

Result<std::unique_ptr<Integrator>> PathIntegrator::Create(const Scene& scene,
                                                           const IntegratorOptions& options) {
  PathTechniques techniques;
  techniques.light_choice = options.light_choice;
  return std::unique_ptr<Integrator>(std::make_unique<PathIntegrator>(scene, options, techniques));
}

std::unique_ptr<Workspace> PathIntegrator::MakeWorkspace() const {
  return std::make_unique<Batch>();
}

void PathIntegrator::Trace(std::span<const SampleRequest> samples, Workspace* workspace,
                           const SampleOutput& output) const {
  Batch* batch = static_cast<Batch*>(workspace);
  ForEachPart(samples, output, kMostTogether,
              [&](auto part, const SampleOutput& of_part) { Follow(part, batch, of_part); });
}

void PathIntegrator::Follow(std::span<const SampleRequest> samples, Batch* batch,
                            const SampleOutput& output) const {
  PathQueue<uint32_t>& paths = batch->paths;
  paths.Resize(samples.size());
  const auto states = FirstOf(&batch->states, samples.size());
  const Camera& camera = scene_.camera();
  const bool is_pinhole = camera.IsPinhole();
  const CameraFootprint footprint = camera.FootprintPerUnit();
  PathState first;
  first.media = media_at_camera_;
  const bool is_moving = times_.AreNeeded();
  if (is_pinhole && !is_moving) {
    const auto image_points = FirstOf(&batch->image_points, samples.size());
    for (size_t i = 0; i < samples.size(); ++i) image_points[i] = samples[i].image_point;
    camera.GenerateRays(image_points, paths.rays().data());
  }
  size_t started = 0;
  batch->samplers.clear();
  for (uint32_t i = 0; i < samples.size(); ++i) {
    const SampleRequest& request = samples[i];
    paths.states()[i] = i;
    PathState& path = states[i];
    path = first;
    path.sample = i;
    path.cone = {request.spacing * footprint.width, request.spacing * footprint.spread};
    const Sampler sampler(seed_, request.x, request.y, request.index, sampler_);
    Ray& ray = paths.rays()[i];
    if (is_moving) {
      std::optional<Vec2> u;
      if (!is_pinhole) u = sampler.Get2D(kLensDimension);
      ray = CameraRayAt(scene_, times_.Draw(sampler), request.image_point, u);
    } else if (!is_pinhole) {
      ray = camera.GenerateRay(request.image_point, sampler.Get2D(kLensDimension));
    }
    if (scene_.HasDispersion()) path.colour.Draw(sampler);
    output.Clear(i);
    if (ray.direction == Vec3()) continue;
    if (!starts_in_one_place_) path.media = MediaAround(scene_, ray.origin, ray.time);
    paths.MoveTo(started++, i);
    batch->samplers.push_back(sampler);
  }
  paths.Resize(started);
  batch->rays.camera += started;

  RayOrder order = is_pinhole ? RayOrder::kCoherent : RayOrder::kScattered;
  for (uint32_t step = 0; paths.size() > 0; ++step) {
    paths.FindHits(scene_, order);
    Shade(step, batch, output);
    AddSampledLight(batch, output);
    order = RayOrder::kScattered;
  }
}

void PathIntegrator::Shade(uint32_t step, Batch* batch, const SampleOutput& output) const {
  batch->contributions.clear();
  batch->shadow_rays.clear();
  PathQueue<uint32_t>& paths = batch->paths;
  const bool samples_lights = lights_.CanSample();
  batch->numbers.Draw({batch->samplers.data(), paths.size()}, step,
                      {.light_point = samples_lights,
                       .light_choice = samples_lights && lights_.HasChoice(),
                       .roulette = has_roulette_ && step >= kRouletteAfter});
  size_t left = 0;
  // Path i goes on, along a ray that is in its new place already.
  const auto keep = [&](size_t i) {
    paths.states()[left] = paths.states()[i];
    batch->samplers[left] = batch->samplers[i];
    ++left;
  };
  for (size_t i = 0; i < paths.size(); ++i) {
    const Ray& ray = paths.rays()[i];
    const HitRecord& hit = paths.hits()[i];
    PathState& path = batch->states[paths.states()[i]];
    if (!hit.IsHit()) {
      const Spectrum left_of_it = EndlessTransmittance(path.media.Absorption(scene_.interiors()));
      const auto add_to_group = [&](uint32_t group, const Spectrum& part) {
        output.AddToGroup(path.sample, group, path.throughput * (part * left_of_it));
      };
      const Spectrum light = lights_.FromSky(path, ray.direction, add_to_group) * left_of_it;
      output.Add(path.sample, path.bounces.all, path.throughput * light);
      continue;
    }
    if (!path.media.IsEmpty()) {
      path.throughput *= Transmittance(path.media.Absorption(scene_.interiors()), hit.t);
    }
    PathVertex vertex(scene_, ray, hit);
    path.cone.Travel(hit.t);
    vertex.point.footprint = path.cone.width;
    const SceneObject& object = scene_.objects()[hit.object];
    if (object.light != SceneObject::kNoLight) {
      const Spectrum light =
          path.throughput * lights_.FromSurface(path, vertex.point, vertex.wo, object.light);
      output.Add(path.sample, path.bounces.all, light);
      output.AddToGroup(path.sample, scene_.GroupOfLight(object.light), light);
    }
    if (object.interior != SceneObject::kNoInterior &&
        !FindMedia(scene_.interiors(), object.interior, path.media, &batch->rays, &vertex)) {
      path.media = vertex.media_beyond;
      path.pdf = 0;  // Rays to sampled lights do not pass: a body has no holes.
      paths.rays()[left] = PassOn(vertex);
      keep(i);
      continue;
    }
    vertex.material = &scene_.material(hit);
    const bool is_last = !limits_.Allow(path.bounces);
    const bool is_recorded = !path.has_met_surface && output.HasLayers();
    path.has_met_surface = true;
    if (is_last && !vertex.material->HasHoles() && !is_recorded) continue;

    vertex.bsdf.wavelength = path.colour.wavelength;
    vertex.Evaluate();
    path.colour.Split(vertex.bsdf, &path.throughput);
    if (is_recorded) {
      SampleLayers& layers = output.layers[path.sample];
      layers.albedo = AlbedoOf(vertex.bsdf);
      if (output.WantsSurface(path.sample)) {
        layers.surface = RecordSurface(scene_, ray, hit, vertex.point, output.needs_uv);
      }
    }
    if (has_lift_ && vertex.point.n_shading != vertex.point.n_geometric) Lift(hit, &vertex);
    // Not by bounces: what is seen through a hole no light path brings.
    const bool is_left_out = beyond_light_paths_ && step == 0;
    const BounceNumbers numbers = batch->numbers[i];
    if (!is_last && samples_lights && vertex.bsdf.HasSmoothPart() && !is_left_out) {
      SampleLight(path, numbers, vertex, batch);
    }
    // This may be where `ray` is, which has served.
    if (Scatter(step, numbers, vertex, &path, &paths.rays()[left])) keep(i);
  }
  paths.Resize(left);
  batch->rays.reflection += left;
}

void PathIntegrator::SampleLight(const PathState& path, const BounceNumbers& numbers,
                                 const PathVertex& vertex, Batch* batch) const {
  const Vec3 wo = vertex.wo;
  const Bsdf& bsdf = vertex.bsdf;
  const PathLights::Draw draw =
      lights_.Sample(vertex.AsReceiver(), numbers.light_choice, numbers.light_point);
  const LightSample& sample = draw.sample;
  if (sample.pdf == 0 || sample.radiance.IsBlack()) return;

  const Vec3 wi = sample.direction;
  const float cosine = Dot(bsdf.frame.z, wi);
  const bool is_transmission = cosine < 0;
  const BounceKind kind = KindOf(false, is_transmission);
  if (!limits_.Allow(path.bounces, kind)) return;
  if (IsOnWrongSide(vertex, wi, is_transmission)) return;
  const BsdfValue scattered =
      draw.is_found_too ? EvalWithPdf(bsdf, wo, wi) : BsdfValue{Eval(bsdf, wo, wi), 0};
  if (scattered.value.IsBlack()) return;

  const float weight = draw.is_found_too ? lights_.Weight(draw.Pdf(), scattered.pdf) : 1;
  Spectrum arriving = sample.radiance * (std::abs(cosine) * weight / draw.Pdf());
  const MediumStack& media = is_transmission ? vertex.media_beyond : path.media;
  if (!media.IsEmpty()) {
    arriving *= Transmittance(media.Absorption(scene_.interiors()), sample.distance);
  }

  Ray ray = LeavingRay(vertex, wi);
  ray.t_max = sample.distance;
  ray.mask = kShadowRay;
  batch->shadow_rays.push_back(ray);
  batch->contributions.push_back({path.sample, path.bounces.all + 1, draw.group,
                                  path.throughput * scattered.value * arriving});
}

void PathIntegrator::AddSampledLight(Batch* batch, const SampleOutput& output) const {
  const size_t count = batch->shadow_rays.size();
  batch->rays.shadow += count;
  scene_.Occluded(RayOrder::kScattered, batch->shadow_rays, FirstOf(&batch->is_shadowed, count));
  for (size_t i = 0; i < count; ++i) {
    if (batch->is_shadowed[i]) continue;
    const auto& [sample, times_scattered, group, value] = batch->contributions[i];
    const float left = scene_.HasHoles() ? scene_.Transparency(batch->shadow_rays[i]) : 1;
    output.Add(sample, times_scattered, value * left);
    output.AddToGroup(sample, group, value * left);
  }
}

void PathIntegrator::Lift(const HitRecord& hit, PathVertex* vertex) const {
  if (!vertex->bsdf.IsOpaque()) return;  // What goes through starts on the true surface.
  const bool is_inside = Dot(vertex->point.OutwardNormal(), vertex->wo) < 0;
  const Vec3 lift = scene_.LiftOf(hit, vertex->point, is_inside);
  if (lift == Vec3()) return;
  vertex->point.p += lift;
  vertex->is_lifted = true;
}

bool PathIntegrator::Scatter(uint32_t step, const BounceNumbers& numbers, const PathVertex& vertex,
                             PathState* path, Ray* ray) const {
  const BsdfSample next = Sample(vertex.bsdf, vertex.wo, numbers.direction);
  if (next.pdf == 0) return false;
  if (next.is_hole) {
    // No event: what is known of the last surface and its ray goes on to be true.
    path->throughput *= next.weight;
    *ray = PassOn(vertex);
    return true;
  }
  if (beyond_light_paths_ && step == 0 && !next.is_delta) return false;
  if (!limits_.Allow(path->bounces)) return false;
  const BounceKind kind = KindOf(next.is_delta, next.is_transmission);
  if (!limits_.Allow(path->bounces, kind)) return false;
  if (IsOnWrongSide(vertex, next.wi, next.is_transmission)) return false;
  path->throughput *= next.weight;
  if (path->throughput.IsBlack()) return false;
  if (next.enters) path->media = vertex.media_beyond;
  path->eta_squared *= next.eta * next.eta;

  // A path that carries little power ends often, and counts for more when it does not.
  DCHECK(path->bounces.all <= step);  // Else no number would have been drawn.
  if (has_roulette_ && path->bounces.all >= kRouletteAfter) {
    const float share = path->throughput.MaxComponent() * path->eta_squared;
    const float most = path->bounces.all < kUncertainAfter ? 1 : 0.95f;
    const float survival = std::min(most, kSurvivalOfShare * share);
    if (numbers.roulette >= survival) return false;
    path->throughput *= Spectrum(1 / survival);
  }
  path->bounces.Add(kind);
  path->pdf = next.is_delta ? 0 : next.pdf;
  if (!next.is_delta) path->cone.Scatter(next.pdf);
  path->receiver = vertex.AsReceiver();
  *ray = LeavingRay(vertex, next.wi);
  ray->mask = kReflectionRay;
  return true;
}

}  // namespace candela
