#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "integrators/distribution.h"
#include "integrators/path_queue.h"
#include "materials/material.h"
#include "sampling/sampler.h"

namespace candela {

// What `DistributionIntegrator` knows while it follows the trees of its samples.

/// The first of the dimensions of a ray of that name.
constexpr uint32_t DimensionOf(uint32_t name) {
  return kCameraDimensions + kBounceDimensions * name;
}

/// A ray of a tree, on its way.
struct DistributionIntegrator::TreeRay {
  uint32_t sample = 0;    ///< Its place in the list.
  uint32_t index = 0;     ///< Which point of the sequences of its pixel it takes,
  uint32_t name = 0;      ///< and of which sequences.
  uint32_t bounces = 0;   ///< By mirrors and through surfaces,
  uint32_t surfaces = 0;  ///< and by all that it has met.
  bool is_one_of_many = false;
  bool is_gathered = false;  ///< It comes straight from a surface that gathers light,
  Vec3 gathered_from{};      ///< from this point of it.
  bool is_inside = false;    ///< It is in a body,
  Rgb absorption{};          ///< which does this to it.
  float time = 0;            ///< Of all rays of the tree.
  Rgb throughput{1, 1, 1};
  Sampler sampler;
};

/// What is to be known of the surface that a ray has met, and the light there so far.
struct DistributionIntegrator::Shading {
  Vec3 p, normal;      ///< As the course has them.
  SurfacePoint point;  ///< To start rays from.
  Vec3 eye;            ///< The unit direction that the ray came along,
  Vec3 mirrored;       ///< and that in which it goes on.
  PhongTerms terms;
  PhongOptics optics;
  bool reflects = false;
  Rgb reflection;           ///< What the mirrored rays are multiplied by,
  Rgb refraction;           ///< and the refracted one.
  Vec3 refracted;           ///< A unit vector.
  bool is_outside = false;  ///< The ray came from where the normal points to.
  Rgb light;
};

struct DistributionIntegrator::Batch final : Workspace {
  struct LampLight {
    size_t place;  ///< Of the surface in the list.
    Rgb light;
  };

  std::span<const SampleRequest> samples;
  PathQueue<TreeRay> paths;
  std::vector<Vec2> image_points;
  std::vector<Rgb> sums;  ///< By sample.
  std::vector<Shading> shadings;
  std::vector<LightSample> light_samples;  ///< Of one light without a surface.
  std::vector<LampLight> lamp_lights;      ///< Of one with a surface.
  std::vector<Ray> shadow_rays;
  std::vector<uint8_t> is_shadowed;
  std::vector<TreeRay> next_paths;
  std::vector<Ray> next_rays;

  void Add(const TreeRay& path, uint32_t times_scattered, Rgb light, const SampleOutput& output) {
    if (output.HasLayers()) output.layers[path.sample].AddLight(times_scattered, light);
  }
};

}  // namespace candela
