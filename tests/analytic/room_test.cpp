// Closed rooms, in which light is reflected again and again.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "integrators/path.h"
#include "integrators/registry.h"
#include "math/elementary.h"
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::EstimateRadiance;
using testing_support::ExpectEstimate;
using testing_support::kCamera;

constexpr Vec2 kSomewhere = {0.2f, -0.4f};

IntegratorOptions Bounces(std::optional<uint32_t> bounces) {
  IntegratorOptions options;
  options.bounces = bounces;
  options.seed = 1;
  return options;
}

/// A sphere of the given radius and of albedo 1/2 around the camera, with a light in its node.
std::string Room(float radius, const std::string& light) {
  return fmt::format(
      "{}Materials {{ Material {{ type diffuse albedo 0.5 0.5 0.5 }} }}\n"
      "Scene {{ Component<Object> {{ type sphere radius {} }} Component<Material> {{ index 0 }}\n"
      "Component<Light> {{ {} }} }}",
      kCamera, radius, light);
}

const std::string kGlowing = "type area radiance 0.5 0.5 0.5";

/// A point light of intensity pi.
std::string Lamp() {
  return fmt::format("type point color {0:.9g} {0:.9g} {0:.9g} attenuation 1", kPi);
}

// L = Le + rho L, so L = Le / (1 - rho): with 1/2 and 1/2 every pixel is 1.
TEST(GlowingRoom, RadianceIsEmissionOverOneMinusAlbedo) {
  const auto scene = CompileText(Room(1, kGlowing));
  ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, Bounces({})), kSomewhere, 256, 1024), 1);
}

// Cut after n reflections: Le (1 - rho^(n + 1)) / (1 - rho).
TEST(GlowingRoom, EachReflectionAddsItsTermOfTheSeries) {
  const auto scene = CompileText(Room(1, kGlowing));
  const struct {
    uint32_t bounces;
    double radiance;
  } cases[] = {{0, 0.5}, {1, 0.75}, {4, 0.96875}, {8, 0.99804688}};
  for (const auto& [bounces, radiance] : cases) {
    ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, Bounces(bounces)), kSomewhere, 256, 512),
                   radiance);
  }
}

// The wall at distance 1 receives E = pi and reflects rho E / pi = 1/2.
TEST(RoomWithALampInItsMiddle, DirectLightIsAlbedoTimesIrradianceOverPi) {
  const auto scene = CompileText(Room(1, Lamp()));
  ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, Bounces(1)), kSomewhere, 2, 16), 0.5);
}

// All reflections together: (rho / pi) I / r^2 / (1 - rho).
TEST(RoomWithALampInItsMiddle, RadianceFallsWithTheSquareOfTheRadius) {
  const auto near = CompileText(Room(1, Lamp()));
  ExpectEstimate(EstimateRadiance(PathIntegrator(*near, Bounces({})), kSomewhere, 256, 1024), 1);
  const auto far = CompileText(Room(2, Lamp()));
  ExpectEstimate(EstimateRadiance(PathIntegrator(*far, Bounces({})), kSomewhere, 256, 1024), 0.25);
}

}  // namespace
}  // namespace candela
