#include "integrators/path.h"

#include <algorithm>
#include <limits>

#include "geometry/spawn_ray.h"
#include "integrators/path_queue.h"
#include "integrators/path_vertex.h"
#include "integrators/physical_scene.h"
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

// What the dimensions of a bounce are used for.
enum BounceUse : uint32_t { kDirection = 0, kRoulette = 2, kLightChoice = 3, kLightPoint = 4 };

/// Lights of a scene, as the path integrator numbers them.
std::vector<const Light*> LightsOf(const Scene& scene, const EnvironmentLight* environment) {
  std::vector<const Light*> lights;
  for (const auto& light : scene.lights()) lights.push_back(light.get());
  if (environment) lights.push_back(environment);
  return lights;
}

std::unique_ptr<const EnvironmentLight> EnvironmentOf(const Background& background) {
  if (background.environment) return std::make_unique<EnvironmentLight>(*background.environment);
  if (background.cube_map) return std::make_unique<EnvironmentLight>(*background.cube_map);
  // Of a sky that is the same everywhere no direction is better than another: the surface's own
  // choice is the best there is.
  return nullptr;
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

/// A sample on its way.
struct PathIntegrator::Path {
  uint32_t sample = 0;  ///< Its place in the list.
  Sampler sampler{0, 0, 0, 0};
  Spectrum throughput = Spectrum(1);
  Rgb absorption{};  ///< Of the medium that it is in.
  /// What brings `throughput`, which is about radiance, to a share of power: the square of the
  /// refractive index.
  float eta_squared = 1;
  std::array<uint16_t, 3> bounces_of_kind{};
  /// The density with which the last surface has drawn the ray, over solid angle; 0 when a sampled
  /// light could not have done it: from the camera and from mirrors.
  float pdf = 0;
  Vec3 p;  ///< The point of that surface.
};

/// What is known of samples that are followed together.
struct PathIntegrator::Batch final : Workspace {
  /// What comes from a sampled light if nothing is in the way.
  struct Contribution {
    uint32_t sample;
    Spectrum value;
  };

  PathQueue<Path> paths;
  std::vector<Contribution> contributions;
  std::vector<Ray> shadow_rays;      ///< That each of them depends on,
  std::vector<uint8_t> is_shadowed;  ///< and whether something is in the way.
};

PathIntegrator::PathIntegrator(const Scene& scene, const IntegratorOptions& options,
                               const PathTechniques& techniques)
    : scene_(scene),
      environment_(EnvironmentOf(scene.background())),
      lights_(LightsOf(scene, environment_.get())),
      picker_(techniques.next_event ? lights_ : OnlyPoints(lights_), SizeOf(scene),
              techniques.light_choice),
      bounces_(options.bounces.value_or(kUnlimited)),
      bounces_of_kind_{options.diffuse_bounces.value_or(kUnlimited),
                       options.mirror_bounces.value_or(kUnlimited),
                       options.transmission_bounces.value_or(kUnlimited)},
      seed_(options.seed),
      techniques_(techniques) {
  for (uint32_t i = 0; i < scene.lights().size(); ++i) {
    if (lights_[i]->Kind() == LightKind::kSky) suns_.push_back(i);
  }
}

Result<std::unique_ptr<Integrator>> PathIntegrator::Create(const Scene& scene,
                                                           const IntegratorOptions& options) {
  if (const auto checked = CheckPhysical(scene, "path"); !checked) return checked.error();
  return std::unique_ptr<Integrator>(std::make_unique<PathIntegrator>(scene, options));
}

std::unique_ptr<Workspace> PathIntegrator::MakeWorkspace() const {
  return std::make_unique<Batch>();
}

void PathIntegrator::Trace(std::span<const SampleRequest> samples, Workspace* workspace,
                           std::span<Spectrum> radiance) const {
  Batch* batch = static_cast<Batch*>(workspace);
  for (size_t begin = 0; begin < samples.size(); begin += kMostTogether) {
    const size_t count = std::min(kMostTogether, samples.size() - begin);
    Follow(samples.subspan(begin, count), batch, radiance.subspan(begin, count));
  }
}

void PathIntegrator::Follow(std::span<const SampleRequest> samples, Batch* batch,
                            std::span<Spectrum> radiance) const {
  PathQueue<Path>& paths = batch->paths;
  paths.Resize(samples.size());
  const bool is_pinhole = scene_.camera().IsPinhole();
  for (uint32_t i = 0; i < samples.size(); ++i) {
    const SampleRequest& request = samples[i];
    Path& path = paths.states()[i];
    path = Path();
    path.sample = i;
    path.sampler = Sampler(seed_, request.x, request.y, request.index);
    paths.rays()[i] = is_pinhole ? scene_.camera().GenerateRay(request.image_point)
                                 : scene_.camera().GenerateRay(request.image_point,
                                                               path.sampler.Get2D(kLensDimension));
    radiance[i] = Spectrum();
  }
  batch->rays.camera += samples.size();

  RayOrder order = is_pinhole ? RayOrder::kCoherent : RayOrder::kScattered;
  for (uint32_t bounce = 0; paths.size() > 0; ++bounce) {
    paths.FindHits(scene_, order);
    Shade(bounce, batch, radiance);
    AddSampledLight(batch, radiance);
    order = RayOrder::kScattered;
  }
}

void PathIntegrator::Shade(uint32_t bounce, Batch* batch, std::span<Spectrum> radiance) const {
  batch->contributions.clear();
  batch->shadow_rays.clear();
  PathQueue<Path>& paths = batch->paths;
  size_t left = 0;
  for (size_t i = 0; i < paths.size(); ++i) {
    const Ray& ray = paths.rays()[i];
    const HitRecord& hit = paths.hits()[i];
    Path& path = paths.states()[i];
    if (!hit.IsHit()) {
      radiance[path.sample] += path.throughput * FromSky(path, ray.direction);
      continue;
    }
    if (path.absorption != Rgb()) path.throughput *= Transmittance(path.absorption, hit.t);
    PathVertex vertex;
    vertex.point = scene_.SurfaceAt(ray, hit);
    vertex.wo = -Normalize(ray.direction);
    if (const uint32_t lamp = scene_.objects()[hit.object].light; lamp != SceneObject::kNoLight) {
      radiance[path.sample] += path.throughput * FromSurface(path, vertex.point, vertex.wo, lamp);
    }
    if (bounce == bounces_) continue;

    vertex.material = &scene_.material(hit);
    vertex.Evaluate();
    const bool is_left_out = techniques_.beyond_light_paths && bounce == 0;
    if (picker_.HasLights() && vertex.bsdf.HasSmoothPart() && !is_left_out) {
      SampleLight(path, bounce, vertex, batch);
    }
    Ray next;
    if (!Scatter(bounce, vertex, &path, &next)) continue;
    paths.states()[left] = path;
    paths.rays()[left] = next;
    ++left;
  }
  paths.Resize(left);
  batch->rays.reflection += left;
}

Spectrum PathIntegrator::FromSky(const Path& path, Vec3 direction) const {
  Spectrum sum = scene_.background().Radiance(direction);
  if (environment_) {
    const auto index = static_cast<uint32_t>(lights_.size() - 1);
    sum *= Spectrum(WeightOfFound(path, index, {}, direction));
  }
  for (const uint32_t sun : suns_) {
    const Spectrum light = lights_[sun]->Emitted({}, -direction);
    if (!light.IsBlack()) sum += light * WeightOfFound(path, sun, {}, direction);
  }
  // Through a medium without end comes only what it does not absorb at all.
  const auto left = [](float absorption) { return absorption > 0 ? 0.0f : 1.0f; };
  const Rgb a = path.absorption;
  return a == Rgb() ? sum : sum * Spectrum(Rgb{left(a.x), left(a.y), left(a.z)});
}

Spectrum PathIntegrator::FromSurface(const Path& path, const SurfacePoint& point, Vec3 wo,
                                     uint32_t light) const {
  const Spectrum emitted = lights_[light]->Emitted(point, wo);
  if (emitted.IsBlack()) return {};
  return emitted * WeightOfFound(path, light, point, -wo);
}

/// How much of a light counts that a ray along `w` has found, where it could have been sampled too.
float PathIntegrator::WeightOfFound(const Path& path, uint32_t light, const SurfacePoint& point,
                                    Vec3 w) const {
  if (path.pdf == 0 || !techniques_.next_event) return 1;
  const float choice = picker_.Probability(path.p, light);
  if (choice == 0) return 1;
  return Weight(path.pdf, choice * lights_[light]->PdfIncident(path.p, point, w));
}

/// The part that falls to a technique of density `pdf` when another has `other_pdf`.
float PathIntegrator::Weight(float pdf, float other_pdf) const {
  if (other_pdf == 0) return 1;
  const float ratio = other_pdf / pdf;
  const bool is_power = techniques_.weights == PathTechniques::Weights::kPowerHeuristic;
  return 1 / (1 + (is_power ? ratio * ratio : ratio));
}

void PathIntegrator::SampleLight(const Path& path, uint32_t bounce, const PathVertex& vertex,
                                 Batch* batch) const {
  const auto& [point, wo, material, bsdf] = vertex;
  const uint32_t dimension = BounceDimension(bounce);
  const float u = picker_.NeedsNumber() ? path.sampler.Get1D(dimension + kLightChoice) : 0;
  const auto [index, choice] = picker_.Choose(point.p, u);
  const Light& light = *lights_[index];
  const LightSample sample =
      light.SampleIncident(point.p, path.sampler.Get2D(dimension + kLightPoint));
  if (sample.pdf == 0 || sample.radiance.IsBlack()) return;

  const Vec3 wi = sample.direction;
  const float cosine = Dot(bsdf.frame.z, wi);
  const bool is_transmission = cosine < 0;
  const BounceKind kind = KindOf(false, is_transmission);
  if (path.bounces_of_kind[kind] >= bounces_of_kind_[kind]) return;
  if (IsOnWrongSide(point, wo, wi, is_transmission)) return;
  const bool is_found_too = light.Kind() != LightKind::kPoint;
  const BsdfValue scattered =
      is_found_too ? EvalWithPdf(bsdf, wo, wi) : BsdfValue{Eval(bsdf, wo, wi), 0};
  if (scattered.value.IsBlack()) return;

  const float pdf = choice * sample.pdf;
  const float weight = is_found_too ? Weight(pdf, scattered.pdf) : 1;
  Spectrum arriving = sample.radiance * (std::abs(cosine) * weight / pdf);
  const Rgb absorption = is_transmission ? vertex.AbsorptionBeyond() : path.absorption;
  if (absorption != Rgb()) arriving *= Transmittance(absorption, sample.distance);

  Ray ray = SpawnRay(point, wi);
  ray.t_max = sample.distance;
  ray.mask = kShadowRay;
  batch->shadow_rays.push_back(ray);
  batch->contributions.push_back({path.sample, path.throughput * scattered.value * arriving});
}

void PathIntegrator::AddSampledLight(Batch* batch, std::span<Spectrum> radiance) const {
  const size_t count = batch->shadow_rays.size();
  batch->rays.shadow += count;
  scene_.Occluded(RayOrder::kScattered, batch->shadow_rays, FirstOf(&batch->is_shadowed, count));
  for (size_t i = 0; i < count; ++i) {
    const auto& [sample, value] = batch->contributions[i];
    if (!batch->is_shadowed[i]) radiance[sample] += value;
  }
}

bool PathIntegrator::Scatter(uint32_t bounce, const PathVertex& vertex, Path* path,
                             Ray* ray) const {
  const uint32_t dimension = BounceDimension(bounce);
  const BsdfSample next =
      Sample(vertex.bsdf, vertex.wo, path->sampler.Get2D(dimension + kDirection));
  if (next.pdf == 0) return false;
  if (techniques_.beyond_light_paths && bounce == 0 && !next.is_delta) return false;
  const BounceKind kind = KindOf(next.is_delta, next.is_transmission);
  if (path->bounces_of_kind[kind] >= bounces_of_kind_[kind]) return false;
  if (IsOnWrongSide(vertex.point, vertex.wo, next.wi, next.is_transmission)) return false;
  path->throughput *= next.weight;
  if (path->throughput.IsBlack()) return false;
  if (next.enters) path->absorption = vertex.AbsorptionBeyond();
  path->eta_squared *= next.eta * next.eta;

  // A path that carries little power ends often, and counts for more when it does not.
  if (techniques_.roulette && bounce >= kRouletteAfter) {
    const float share = path->throughput.MaxComponent() * path->eta_squared;
    const float most = bounce < kUncertainAfter ? 1 : 0.95f;
    const float survival = std::min(most, kSurvivalOfShare * share);
    if (path->sampler.Get1D(dimension + kRoulette) >= survival) return false;
    path->throughput *= Spectrum(1 / survival);
  }
  if (path->bounces_of_kind[kind] < std::numeric_limits<uint16_t>::max()) {
    ++path->bounces_of_kind[kind];
  }
  path->pdf = next.is_delta ? 0 : next.pdf;
  path->p = vertex.point.p;
  *ray = SpawnRay(vertex.point, next.wi);
  ray->mask = kReflectionRay;
  return true;
}

}  // namespace candela
