#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "integrators/path.h"
#include "integrators/registry.h"
#include "integrators/whitted.h"
#include "tests/support/compile_text.h"

namespace candela {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing_support::CompileText;
using testing_support::kCamera;

// Line 1 is the camera. The wall mirrors half of the background.
const std::string kMirror =
    std::string(kCamera) +
    "Background { color 1 0.5 0.25 ambient_light 0.5 0.5 0.5 }\n"
    "Materials { Material { diffuse 0.5 0.5 0.5 specular 0.5 0.5 0.5 shininess 1 } }\n"
    "Scene {\n"
    "Node { Component<Object> { type plane normal 0 0 1 offset -2 }\n"
    "Component<Material> { index 0 } }\n"
    "Node { Component<Light> { type directional direction 0 0 -1 color 1 1 1 } } }\n";

std::vector<std::string> Explain(const std::string& text, uint32_t bounces, bool shadows = false) {
  const auto scene = CompileText(text);
  return WhittedIntegrator(*scene, bounces, shadows).Explain({});
}

TEST(Explain, TellsTheWholeTreeOfRays) {
  EXPECT_THAT(
      Explain(kMirror, 1),
      ElementsAre(
          "ray from (0, 0, 0) towards (0, 0, -1)",
          "hits the plane of line 5 at distance 2, point (0, 0, -2), normal (0, 0, 1)",
          "material 0: diffuse (0.5, 0.5, 0.5), specular (0.5, 0.5, 0.5), shininess 1",
          "light 0 from direction (0, 0, 1), intensity (1, 1, 1): diffuse adds (0.5, "
          "0.5, 0.5), specular adds (0.5, 0.5, 0.5)",
          "ambient light adds (0.25, 0.25, 0.25)",
          "reflects, weighted with (0.5, 0.5, 0.5):", "  ray from (0, 0, -1.99) towards (0, 0, 1)",
          "  hits nothing and sees the background, (1, 0.5, 0.25)",
          "all together: (1.75, 1.5, 1.375)"));
}

TEST(Explain, SaysWhyItEnds) {
  EXPECT_THAT(Explain(kMirror, 0), Contains("no bounces are left"));
  std::string dull = kMirror;
  dull.replace(dull.find("specular 0.5 0.5 0.5"), 20, "specular 0 0 0      ");
  EXPECT_THAT(Explain(dull, 1), Contains("does not mirror"));
}

TEST(Explain, SaysThatALightIsInShadow) {
  std::string text = kMirror;
  text.insert(text.rfind('}'),
              "Node { Component<Object> { type plane normal 0 0 1 offset 7 } "
              "Component<Material> { index 0 } }");
  EXPECT_EQ(Explain(text, 0, true)[3],
            "light 0 from direction (0, 0, 1), intensity (1, 1, 1): in shadow");
}

// An indent that grows with each reflection would take gigabytes.
TEST(Explain, ThousandsOfReflectionsKeepTheirLinesShort) {
  std::string text = kMirror;
  text.replace(text.find("specular 0.5 0.5 0.5"), 20, "specular 1 1 1      ");
  text.insert(text.rfind('}'),
              "Node { Component<Object> { type plane normal 0 0 -1 offset -2 } "
              "Component<Material> { index 0 } }");
  const std::vector<std::string> lines = Explain(text, 5000);
  EXPECT_THAT(lines, SizeIs(testing::Gt(5000u)));
  size_t longest = 0;
  for (const std::string& line : lines) longest = std::max(longest, line.size());
  EXPECT_LT(longest, 250u);
}

TEST(Explain, IsEmptyForAnIntegratorThatCannotTell) {
  const auto scene = CompileText(std::string(kCamera) + "Scene { }");
  EXPECT_THAT(PathIntegrator(*scene, {}).Explain({}), IsEmpty());
}

TEST(IntegratorRegistry, ANameThatIsUnknownIsAnsweredWithTheNearestOne) {
  const auto scene = CompileText(std::string(kCamera) + "Scene { }");
  const auto integrator = CreateIntegrator("whited", *scene, {});
  ASSERT_FALSE(integrator.ok());
  EXPECT_EQ(integrator.error().code, ErrorCode::kUsage);
  EXPECT_EQ(integrator.error().message,
            "there is no integrator 'whited' (did you mean 'whitted'?); known: 'whitted', 'path', "
            "'light_trace', 'direct', 'ambient_occlusion' or 'debug'");
}

}  // namespace
}  // namespace candela
