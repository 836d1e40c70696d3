#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "integrators/registry.h"
#include "integrators/whitted.h"
#include "tests/support/compile_text.h"

namespace candela::test {

/// With a camera at the origin that looks along -z; the text ends before the last brace.
inline std::unique_ptr<const Scene> SceneOf(const std::string& text) {
  return testing_support::CompileText(testing_support::kCamera + text + " }");
}

/// The wall z = -2, seen head-on from the origin.
inline std::string Wall(const std::string& material, const std::string& background = "") {
  return "Background { " + background + " } Materials { Material { " + material +
         " } Material { diffuse 0 0 0 } Material { type diffuse albedo 0 0 0 } }\n"
         "Scene { Node { Component<Object> { type plane normal 0 0 1 offset -2 } "
         "Component<Material> { index 0 } }\n";
}

inline IntegratorOptions Bounces(uint32_t bounces) {
  IntegratorOptions options;
  options.bounces = bounces;
  options.shadows = true;
  return options;
}

/// The radiance through one image point and the rays that it takes.
struct Seen {
  Rgb color;
  RayCounts rays;
};

inline Seen Trace(const Integrator& integrator, Vec2 image_point = {0, 0}) {
  const auto workspace = integrator.MakeWorkspace();
  SampleRequest request;
  request.image_point = image_point;
  Spectrum radiance;
  integrator.Trace({&request, 1}, workspace.get(), {{&radiance, 1}});
  return {radiance.ToRgb(), workspace->rays};
}

inline Seen Trace(const std::string& text, const IntegratorOptions& options,
                  Vec2 image_point = {0, 0}) {
  const auto scene = SceneOf(text);
  const auto integrator = WhittedIntegrator::Create(*scene, options);
  return Trace(**integrator, image_point);
}

inline void ExpectColor(Rgb color, Rgb expected, float error = 2e-6f) {
  EXPECT_NEAR(color.x, expected.x, error);
  EXPECT_NEAR(color.y, expected.y, error);
  EXPECT_NEAR(color.z, expected.z, error);
}

}  // namespace candela::test
