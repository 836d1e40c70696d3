#pragma once

#include <functional>
#include <utility>

#include "integrators/integrator.h"

namespace candela::testing_support {

/// A picture that is a formula of the image point, in place of a scene: what film and filters make
/// of it can then be told exactly.
class ImageFunction final : public Integrator {
 public:
  explicit ImageFunction(std::function<float(Vec2 image_point)> brightness)
      : brightness_(std::move(brightness)) {}

  void Trace(std::span<const SampleRequest> samples, Workspace* /*workspace*/,
             const SampleOutput& output) const override {
    for (size_t i = 0; i < samples.size(); ++i) {
      output.radiance[i] = Spectrum(brightness_(samples[i].image_point));
    }
  }

 private:
  std::function<float(Vec2)> brightness_;
};

}  // namespace candela::testing_support
