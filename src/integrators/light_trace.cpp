#include "integrators/light_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/spawn_ray.h"
#include "integrators/beers_law.h"
#include "integrators/medium_stack.h"
#include "integrators/path_colour.h"
#include "integrators/path_lights.h"
#include "integrators/path_queue.h"
#include "integrators/path_state.h"
#include "integrators/path_vertex.h"
#include "integrators/physical_scene.h"
#include "integrators/registry.h"
#include "integrators/symmetric_media.h"
#include "lights/environment_light.h"
#include "lights/even_sky_light.h"
#include "sampling/sampler.h"

namespace candela {
namespace {

constexpr uint32_t kRouletteAfter = 4;  // Bounces that every path may take.

// What the dimensions before the first bounce are used for.
constexpr uint32_t kEmitter = 0, kOrigin = 2, kEmission = 4;

/// All light paths of a picture are one sequence, as if they were the samples of one pixel that no
/// picture has, so that they are evenly spread over the lights.
Sampler SamplerOf(uint32_t seed, uint64_t path, SamplerType type) {
  constexpr uint32_t kRowOfLightPaths = 0xFFFFFFFF;
  return {seed, static_cast<uint32_t>(path >> 32), kRowOfLightPaths, static_cast<uint32_t>(path),
          type};
}

/// The samplers that are good with few samples of many pixels are of no use here.
SamplerType TypeForOnePixel(SamplerType type) {
  return type.kind == SamplerKind::kIndependent ? type : SamplerKind::kSobol;
}

/// Null when the sky is black.
std::unique_ptr<const Light> SkyOf(const Background& background) {
  if (auto environment = EnvironmentOf(background)) return environment;
  if (background.color == Rgb()) return nullptr;
  return std::make_unique<EvenSkyLight>(Spectrum(background.color));
}

bool ShinesFromAfar(const Scene& scene) {
  const bool has_far_light =
      std::any_of(scene.lights().begin(), scene.lights().end(), [](const auto& light) {
        const LightReach reach = light->Reach();
        return reach.is_far && reach.power > 0;
      });
  const Background& sky = scene.background();
  return has_far_light || sky.environment || sky.cube_map || sky.color != Rgb();
}

/// Whether something depends on the bodies that light is in.
bool HasMedia(const Scene& scene) {
  return std::any_of(scene.interiors().begin(), scene.interiors().end(), [](const auto& interior) {
    return interior.is_explicit || interior.medium.absorption != Rgb();
  });
}

PathTechniques BeyondLightPaths(LightChoice light_choice) {
  PathTechniques techniques;
  techniques.light_choice = light_choice;
  techniques.beyond_light_paths = true;
  techniques.lift = false;  // Light paths start from the true surface.
  return techniques;
}

/// The same surface as a path sees it that comes from another side.
PathVertex SeenFrom(const PathVertex& vertex, Vec3 wo) {
  PathVertex seen(vertex.point, wo);
  seen.material = vertex.material;
  const Vec3 n = vertex.point.n_geometric;
  const bool is_same_side = Dot(n, wo) * Dot(n, vertex.wo) > 0;
  seen.bsdf.medium_here = is_same_side ? vertex.bsdf.medium_here : vertex.bsdf.medium_beyond;
  seen.bsdf.medium_beyond = is_same_side ? vertex.bsdf.medium_beyond : vertex.bsdf.medium_here;
  seen.bsdf.wavelength = vertex.bsdf.wavelength;
  seen.Evaluate();
  return seen;
}

}  // namespace

/// A path on its way from a light.
struct LightTraceIntegrator::Path {
  Sampler sampler;
  Spectrum flux;                      ///< What the light has sent out,
  Spectrum throughput = Spectrum(1);  ///< and the part of its power that is left.
  MediumStack media;                  ///< What it is in.
  PathColour colour;
  BounceCounts bounces;
};

/// What is known of paths that are followed together.
struct LightTraceIntegrator::Batch final : Workspace {
  std::unique_ptr<Workspace> from_camera;
  PathQueue<Path> paths;
  std::vector<Splat> connections;   ///< What comes to the camera if nothing is in the way.
  std::vector<Ray> camera_rays;     ///< The way of each,
  std::vector<uint8_t> is_blocked;  ///< and whether something is in it.
  std::vector<Vec2> repeats;        ///< Where else one of them is seen.
};

LightTraceIntegrator::LightTraceIntegrator(const Scene& scene, const IntegratorOptions& options)
    : scene_(scene),
      from_camera_(scene, options, BeyondLightPaths(options.light_choice)),
      ball_(BallAround(scene.Bounds())),
      sky_(SkyOf(scene.background())),
      has_media_(HasMedia(scene)),
      limits_(options),
      seed_(options.seed),
      sampler_(TypeForOnePixel(options.sampler)),
      times_(scene, seed_, sampler_) {
  std::vector<double> powers;
  double sum = 0;
  const auto add = [&](const Light& light) {
    const double power = light.Power(ball_);
    if (!(power > 0)) return;
    lights_.push_back(&light);
    powers.push_back(power);
    sum += power;
  };
  for (const auto& light : scene.lights()) add(*light);
  if (sky_) add(*sky_);
  for (const double power : powers) probabilities_.push_back(static_cast<float>(power / sum));
  if (!powers.empty()) choice_.emplace(powers);
}

void LightTraceIntegrator::Check(const Scene& scene, Diagnostics* diagnostics) {
  CheckPhysical(scene, "light_trace", diagnostics);
  CheckMediaAreSymmetric(scene, "light_trace", diagnostics);
  for (size_t i = 0; i < scene.lights().size(); ++i) {
    if (scene.lights()[i]->CanBeSentOut()) continue;
    diagnostics->Error(
        scene.PlaceOfLight(i),
        "no light that is sent out falls off like this, so the integrator 'light_trace' does not "
        "know this 'falloff'; 'path' and 'whitted' do, and all of them know 'falloff 0 0 Q'");
  }
  const bool shines_from_afar = ShinesFromAfar(scene);
  for (size_t i = 0; i < scene.objects().size(); ++i) {
    const SceneObject& object = scene.objects()[i];
    const bool is_lamp = object.light != SceneObject::kNoLight;
    if (is_lamp && scene.lights()[object.light]->IsFoundByHitsAlone()) {
      diagnostics->Error(scene.PlaceOfObject(i), [&] {
        return fmt::format(
            "the {} is a lamp whose surface cannot be sampled, so the integrator "
            "'light_trace' cannot send out its light; 'path' finds it",
            object.type);
      });
      continue;
    }
    const Bounds3 bounds = object.WorldBounds();
    if (shines_from_afar && !bounds.IsFinite()) {
      diagnostics->Error(scene.PlaceOfObject(i), [&] {
        return fmt::format(
            "the {} has no end, so the integrator 'light_trace' cannot send all "
            "of the light from the sky to it; 'path' can, and so can both with a "
            "rectangle",
            object.type);
      });
    }
  }
}

Result<std::unique_ptr<Integrator>> LightTraceIntegrator::Create(const Scene& scene,
                                                                 const IntegratorOptions& options) {
  return std::unique_ptr<Integrator>(std::make_unique<LightTraceIntegrator>(scene, options));
}

std::unique_ptr<Workspace> LightTraceIntegrator::MakeWorkspace() const {
  auto batch = std::make_unique<Batch>();
  batch->from_camera = from_camera_.MakeWorkspace();
  return batch;
}

void LightTraceIntegrator::Trace(std::span<const SampleRequest> samples, Workspace* workspace,
                                 const SampleOutput& output) const {
  Workspace* from_camera = static_cast<Batch*>(workspace)->from_camera.get();
  from_camera->rays = {};
  from_camera_.Trace(samples, from_camera, output);
  workspace->rays += from_camera->rays;
}

void LightTraceIntegrator::TraceLightPaths(uint64_t first, uint64_t count, Workspace* workspace,
                                           std::vector<Splat>* splats) const {
  if (!choice_ || limits_.all == 0) return;
  Batch* batch = static_cast<Batch*>(workspace);
  PathQueue<Path>& paths = batch->paths;
  for (uint64_t begin = 0; begin < count; begin += kMostTogether) {
    const auto together = static_cast<size_t>(std::min<uint64_t>(kMostTogether, count - begin));
    paths.Resize(together);
    size_t started = 0;
    for (size_t i = 0; i < together; ++i) {
      Path& path = paths.states()[started];
      path = Path();
      path.sampler = SamplerOf(seed_, first + begin + i, sampler_);
      if (Emit(&path, &paths.rays()[started])) ++started;
    }
    paths.Resize(started);
    batch->rays.reflection += started;
    for (uint32_t step = 0; paths.size() > 0; ++step) {
      paths.FindHits(scene_, RayOrder::kScattered);
      Shade(step, batch);
      AddConnections(batch, splats);
    }
  }
}

bool LightTraceIntegrator::Emit(Path* path, Ray* ray) const {
  const uint32_t chosen = choice_->Draw(double{path->sampler.Get1D(kEmitter)}).index;
  const Vec2 u_origin = path->sampler.Get2D(kOrigin);
  const Vec2 u_direction = path->sampler.Get2D(kEmission);
  const EmissionSample sample = lights_[chosen]->SampleEmission(ball_, u_origin, u_direction);
  if (sample.flux.IsBlack()) return false;
  path->flux = sample.flux * (1 / probabilities_[chosen]);
  *ray = SpawnRay(sample.origin, sample.direction);
  ray->mask = kReflectionRay;
  if (times_.AreNeeded()) ray->time = times_.Draw(path->sampler);
  if (scene_.HasDispersion()) path->colour.Draw(path->sampler);
  // A path that goes on knows them from the surfaces that it has come through.
  if (has_media_) path->media = MediaAround(scene_, ray->origin, ray->time);
  return true;
}

void LightTraceIntegrator::Shade(uint32_t step, Batch* batch) const {
  batch->connections.clear();
  batch->camera_rays.clear();
  PathQueue<Path>& paths = batch->paths;
  size_t left = 0;
  for (size_t i = 0; i < paths.size(); ++i) {
    const Ray& ray = paths.rays()[i];
    const HitRecord& hit = paths.hits()[i];
    Path& path = paths.states()[i];
    if (!hit.IsHit()) continue;
    if (!path.media.IsEmpty()) {
      path.throughput *= Transmittance(path.media.Absorption(scene_.interiors()), hit.t);
    }
    PathVertex vertex(scene_, ray, hit);
    const SceneObject& object = scene_.objects()[hit.object];
    if (object.interior != SceneObject::kNoInterior &&
        !FindMedia(scene_.interiors(), object.interior, path.media, &batch->rays, &vertex)) {
      path.media = vertex.media_beyond;
      paths.states()[left] = path;
      paths.rays()[left] = PassOn(vertex);
      ++left;
      continue;
    }
    vertex.material = &scene_.material(hit);
    vertex.bsdf.wavelength = path.colour.wavelength;
    vertex.Evaluate();
    path.colour.Split(vertex.bsdf, &path.throughput);
    if (vertex.bsdf.HasSmoothPart()) Connect(path, step, vertex, batch);
    Ray next;
    if (!Scatter(step, vertex, &path, &next)) continue;
    paths.states()[left] = path;
    paths.rays()[left] = next;
    ++left;
  }
  paths.Resize(left);
  batch->rays.reflection += left;
}

// What stands before the surface blocks its way to the camera, even with a hole there or where it
// lies hidden in another body: what a ray from the camera sees beyond is brought by `Trace`.
void LightTraceIntegrator::Connect(const Path& path, uint32_t step, const PathVertex& vertex,
                                   Batch* batch) const {
  const bool is_pinhole = scene_.camera().IsPinhole();
  const Vec2 u = is_pinhole ? Vec2() : path.sampler.Get2D(BounceDimension(step) + kLens);
  const std::optional<CameraConnection> camera =
      scene_.camera().ConnectAt(vertex.time, vertex.point.p, u);
  if (!camera) return;

  // The value is for light that comes from the other direction, as a path from the camera would
  // have it.
  const PathVertex from_camera = SeenFrom(vertex, camera->direction);
  const Vec3 n = vertex.point.n_geometric, wo = camera->direction, wi = vertex.wo;
  const float cosine = Dot(from_camera.bsdf.frame.z, wi);
  const bool is_transmission = cosine < 0;
  const BounceKind kind = KindOf(false, is_transmission);
  if (!limits_.Allow(path.bounces, kind)) return;
  if (IsOnWrongSide(from_camera, wi, is_transmission)) return;
  Spectrum value = Eval(from_camera.bsdf, wo, wi);
  if (value.IsBlack()) return;

  // Light arrives by the cosine to the true surface, and leaves by it; see `Scatter`.
  const float arriving = std::abs(Dot(n, wi)), leaving = std::abs(Dot(n, wo));
  if (!(arriving > 0)) return;
  value *= Spectrum(std::abs(cosine) / arriving * leaving * camera->importance);
  const MediumStack& media = is_transmission ? vertex.media_beyond : path.media;
  if (!media.IsEmpty()) {
    value *= Transmittance(media.Absorption(scene_.interiors()), camera->distance);
  }

  Ray ray = SpawnRay(vertex.point, wo);
  ray.time = vertex.time;
  ray.t_max = camera->distance;
  ray.mask = kCameraRay;
  batch->camera_rays.push_back(ray);
  batch->connections.push_back({camera->image_point, path.flux * path.throughput * value});
}

void LightTraceIntegrator::AddConnections(Batch* batch, std::vector<Splat>* splats) const {
  const size_t count = batch->camera_rays.size();
  batch->rays.shadow += count;
  scene_.Occluded(RayOrder::kScattered, batch->camera_rays, FirstOf(&batch->is_blocked, count));
  for (size_t i = 0; i < count; ++i) {
    if (batch->is_blocked[i]) continue;
    const Splat& splat = batch->connections[i];
    splats->push_back(splat);
    if (!scene_.camera().Repeats()) continue;
    batch->repeats.clear();
    scene_.camera().AddRepeats(splat.image_point, &batch->repeats);
    for (const Vec2 image_point : batch->repeats) splats->push_back({image_point, splat.radiance});
  }
}

// A Bsdf is about radiance: the weight of its sample, which stands for light on its way to `wo`,
// holds for light on its way from there too, as far as it is symmetric. What is not: light that
// gets into a body of another refractive index keeps its power, not its radiance; and a shading
// normal stands in for the true one in the cosine of light that arrives: Veach, "Robust Monte Carlo
// Methods for Light Transport Simulation", 1997, sections 5.2 and 5.3.
bool LightTraceIntegrator::Scatter(uint32_t step, const PathVertex& vertex, Path* path,
                                   Ray* ray) const {
  const uint32_t dimension = BounceDimension(step);
  const BsdfSample next =
      Sample(vertex.bsdf, vertex.wo, path->sampler.Get2D(dimension + kDirection));
  if (next.pdf == 0) return false;
  if (next.is_hole) {
    path->throughput *= next.weight;
    *ray = PassOn(vertex);
    return true;
  }
  if (path->bounces.all + 1 >= limits_.all)
    return false;  // What it would meet could not be connected.
  const BounceKind kind = KindOf(next.is_delta, next.is_transmission);
  if (!limits_.Allow(path->bounces, kind)) return false;
  const SurfacePoint& point = vertex.point;
  if (IsOnWrongSide(vertex, next.wi, next.is_transmission)) return false;
  const Vec3 n = vertex.bsdf.frame.z;
  const float arriving = Dot(n, vertex.wo) / Dot(point.n_geometric, vertex.wo);
  const float leaving = Dot(point.n_geometric, next.wi) / Dot(n, next.wi);
  const float correction = next.eta * next.eta * std::abs(arriving * leaving);
  if (!std::isfinite(correction)) return false;  // It goes along the surface.
  path->throughput *= next.weight * correction;
  if (path->throughput.IsBlack()) return false;
  if (next.enters) path->media = vertex.media_beyond;

  // What carries little of the power ends often, and counts for more when it does not.
  if (path->bounces.all >= kRouletteAfter) {
    const float survival = std::min(0.95f, path->throughput.MaxComponent());
    if (path->sampler.Get1D(dimension + kRoulette) >= survival) return false;
    path->throughput *= Spectrum(1 / survival);
  }
  path->bounces.Add(kind);
  *ray = LeavingRay(vertex, next.wi);
  ray->mask = kReflectionRay;
  return true;
}

}  // namespace candela
