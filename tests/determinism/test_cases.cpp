#include "tests/determinism/test_cases.h"

#include <gtest/gtest.h>

#include <utility>

#include "film/pixel_filter.h"
#include "integrators/registry.h"
#include "tests/determinism/random_mesh_scene.h"
#include "tests/determinism/random_scene.h"
#include "tests/support/render_scene.h"

namespace candela::determinism {

namespace {

Subject WithIntegrator(const std::string& integrator, std::unique_ptr<Scene> scene) {
  Subject subject{std::move(scene), nullptr};
  if (!subject.scene) return subject;
  IntegratorOptions options;
  options.shadows = true;
  const bool has_many_rays = integrator == "distribution";
  if (integrator == "whitted" || has_many_rays) options.bounces = 3;
  if (has_many_rays) {
    options.light_samples = 3;
    options.glossy_samples = 4;
    options.indirect_samples = 5;
    options.depth_of_field = true;
  }
  auto created = CreateIntegrator(has_many_rays ? "whitted" : integrator, *subject.scene, options);
  if (!created) {
    ADD_FAILURE() << created.error().message;
    return subject;
  }
  subject.integrator = std::move(*created);
  return subject;
}

std::string TextFor(const std::string& integrator, uint32_t seed) {
  if (integrator == "whitted") return RandomScene(seed);
  if (integrator == "distribution") return RandomDistributionScene(seed);
  const bool is_from_lights = integrator == "light_trace";
  return RandomDiffuseScene(seed, is_from_lights ? Paths::kFromLights : Paths::kFromCamera);
}

}  // namespace

Subject MakeSubject(const std::string& integrator, uint32_t seed, AcceleratorKind accelerator) {
  return WithIntegrator(integrator,
                        testing_support::SceneOfText(TextFor(integrator, seed), ".", accelerator));
}

Subject MakeMeshSubject(const std::string& integrator, uint32_t seed, AcceleratorKind accelerator) {
  return WithIntegrator(
      integrator,
      testing_support::SceneOfSpec(RandomMeshScene(seed, TextFor(integrator, seed)), accelerator));
}

Subject MakeMovingSubject(const std::string& integrator, uint32_t seed,
                          AcceleratorKind accelerator) {
  SceneSpec spec = RandomMeshScene(seed, TextFor(integrator, seed));
  SetInMotion(seed, &spec);
  return WithIntegrator(integrator, testing_support::SceneOfSpec(spec, accelerator));
}

std::vector<Placement> AllPlacements() {
  std::vector<Placement> all = {
      {"centre", SamplePattern::kCentre, 1},
      {"strata", SamplePattern::kStrata, kStrataSamples},
      {"strata_tent", SamplePattern::kStrataTent, kStrataSamples},
  };
  for (const PixelFilterEntry& filter : PixelFilters()) {
    const std::string name(filter.name);
    all.push_back({"filter_" + name, SamplePattern::kFilter, 5, name});
  }
  return all;
}

std::vector<Placement> ComparedPlacements() {
  std::vector<Placement> compared = AllPlacements();
  // Those without a filter, and the first filter.
  if (testing_support::kIsSanitized) compared.resize(4);
  return compared;
}

RenderOptions OptionsFor(const Placement& placement, int width, int height) {
  RenderOptions options = testing_support::WholePicture(width, height);
  options.pattern = placement.pattern;
  options.samples = placement.samples;
  options.filter = placement.filter;
  return options;
}

}  // namespace candela::determinism
