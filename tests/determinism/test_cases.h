#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "integrators/integrator.h"
#include "kernel/accelerator_kind.h"
#include "render/render_options.h"
#include "scene/scene.h"
#include "tests/support/effort.h"

namespace candela::determinism {

/// So many random scenes are compared over instruction sets and accelerators.
inline constexpr uint32_t kComparedScenes = testing_support::kIsSanitized ? 1 : 2;

/// A scene with an integrator for it.
struct Subject {
  std::unique_ptr<Scene> scene;
  std::unique_ptr<Integrator> integrator;
};

/// `whitted` with shadows and three bounces, or one of the others, on a random scene that it takes;
/// "distribution" is `whitted` with all that it can do with several rays.
Subject MakeSubject(const std::string& integrator, uint32_t seed,
                    AcceleratorKind accelerator = AcceleratorKind::kBvh);

/// The same on a random scene with meshes.
Subject MakeMeshSubject(const std::string& integrator, uint32_t seed,
                        AcceleratorKind accelerator = AcceleratorKind::kBvh);

/// The same on a random scene in which meshes, other shapes and the camera move.
Subject MakeMovingSubject(const std::string& integrator, uint32_t seed,
                          AcceleratorKind accelerator = AcceleratorKind::kBvh);

/// A way to place samples, with a name for the test.
struct Placement {
  std::string name;
  SamplePattern pattern;
  uint32_t samples;
  std::string filter = "box";
};

/// All patterns, and each row of the table of filters.
std::vector<Placement> AllPlacements();

/// What is compared over threads and crops: under sanitizers one for each pattern.
std::vector<Placement> ComparedPlacements();

/// Everything else as `WholePicture` has it.
RenderOptions OptionsFor(const Placement& placement, int width, int height);

}  // namespace candela::determinism
