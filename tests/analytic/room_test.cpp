// Closed rooms, in which light is reflected again and again.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
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

// CF1: L = Le + rho L, so L = Le / (1 - rho): with 1/2 and 1/2 every pixel is 1.
TEST(GlowingRoom, RadianceIsEmissionOverOneMinusAlbedo) {
  const auto scene = CompileText(Room(1, kGlowing));
  ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, Bounces({})), kSomewhere, 256, 1024), 1);
}

// P12, CF1: cut after n reflections, Le (1 - rho^(n + 1)) / (1 - rho), with and without roulette,
// which begins after four of them. Without it all paths give the sum itself.
TEST(GlowingRoom, EachDepthGivesItsPartialSumWithAndWithoutRoulette) {
  const auto scene = CompileText(Room(1, kGlowing));
  PathTechniques none;
  none.roulette = false;
  for (uint32_t n = 0; n <= 8; ++n) {
    SCOPED_TRACE(n);
    const double sum = 1 - std::pow(0.5, n + 1);
    const auto exact =
        EstimateRadiance(PathIntegrator(*scene, Bounces(n), none), kSomewhere, 4, 64);
    EXPECT_NEAR(exact.mean, sum, 1e-6);
    EXPECT_LE(exact.error, 1e-6);
    ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, Bounces(n)), kSomewhere, 128, 512), sum);
  }
}

// CF2: the wall at distance 1 receives E = pi and reflects rho E / pi = 1/2.
TEST(RoomWithALampInItsMiddle, DirectLightIsAlbedoTimesIrradianceOverPi) {
  const auto scene = CompileText(Room(1, Lamp()));
  ExpectEstimate(EstimateRadiance(PathIntegrator(*scene, Bounces(1)), kSomewhere, 2, 16), 0.5);
}

// CF2: all reflections together: (rho / pi) I / r^2 / (1 - rho).
TEST(RoomWithALampInItsMiddle, RadianceFallsWithTheSquareOfTheRadius) {
  const auto near = CompileText(Room(1, Lamp()));
  ExpectEstimate(EstimateRadiance(PathIntegrator(*near, Bounces({})), kSomewhere, 256, 1024), 1);
  const auto far = CompileText(Room(2, Lamp()));
  ExpectEstimate(EstimateRadiance(PathIntegrator(*far, Bounces({})), kSomewhere, 256, 1024), 0.25);
}

/// A sphere of radius 1 and albedo 0.95 with a lamp of flux 1 in its middle, and a black disk in
/// the place of a cap that is a hundredth of it: light that goes to the cap meets the disk.
std::string IntegratingSphere() {
  return fmt::format(
      "{0}Materials {{ Material {{ type diffuse albedo 0.95 0.95 0.95 }}\n"
      "Material {{ type diffuse albedo 0 0 0 }} }}\n"
      "Scene {{ Component<Object> {{ type sphere radius 1 }} Component<Material> {{ index 0 }}\n"
      "Component<Light> {{ type point color {1:.9g} {1:.9g} {1:.9g} attenuation 1 }}\n"
      "Node {{ Transform {{ translate 0 0 0.98 }} Component<Material> {{ index 1 }}\n"
      "Component<Object> {{ type disk radius 0.19899749 }} }} }}",
      kCamera, 1 / (4 * kPi));
}

// CF14: L = F / (pi A) rho / (1 - rho (1 - f)) for the flux F, the area A and the share f of the
// port. Paths end in the port, not by roulette: that makes less noise.
TEST(IntegratingSphere, HasTheRadianceOfFluxTimesMultiplier) {
  const auto scene = CompileText(IntegratingSphere());
  PathTechniques none;
  none.roulette = false;
  ExpectEstimate(
      EstimateRadiance(PathIntegrator(*scene, Bounces(300), none), kSomewhere, 128, 1024),
      0.404433);
}

}  // namespace
}  // namespace candela
