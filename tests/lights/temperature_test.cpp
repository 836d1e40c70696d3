// The parameter `temperature`, over all kinds of lights.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "lights/registry.h"
#include "tests/contract/rows.h"
#include "textures/black_body.h"

namespace candela {
namespace {

/// What it gives below it, or what its surface gives.
Rgb LightOf(std::string_view parameters) {
  const auto scene = contract::SceneOfLight(parameters);
  const Light& light = *scene->lights()[0];
  if (light.IsSurface()) return light.Emitted({}, {0, -1, 0}).ToRgb();
  return light.SampleIncident({0.01f, -2, 0.02f}).radiance.ToRgb();
}

TEST(Temperature, MultipliesTheColourOfEveryLight) {
  const Rgb factor = BlackBodyColour(2700);
  for (const LightEntry& entry : LightEntries()) {
    SCOPED_TRACE(entry.name);
    const Rgb plain = LightOf(entry.example);
    const Rgb tinted = LightOf(fmt::format("{} temperature 2700", entry.example));
    for (int c = 0; c < 3; ++c) {
      EXPECT_GT(plain[c], 0);
      EXPECT_NEAR(tinted[c] / (plain[c] * factor[c]), 1, 1e-6) << c;
    }
  }
}

}  // namespace
}  // namespace candela
