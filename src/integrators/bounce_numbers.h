#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "integrators/path_queue.h"
#include "integrators/path_state.h"
#include "math/vec.h"
#include "sampling/direction_numbers.h"
#include "sampling/sampler.h"

namespace candela {

/// The random numbers for one bounce of one path from the camera.
struct BounceNumbers {
  DirectionNumbers direction{Vec2()};
  Vec2 light_point;
  float light_choice = 0;
  float roulette = 0;
};

/// Those of many paths that are at the same bounce. They are drawn together, which takes less time
/// than one by one, also where not every path has a use for all of them.
class BounceNumbersOfMany {
 public:
  struct Uses {
    bool light_point, light_choice, roulette;
  };

  void Draw(std::span<const Sampler> samplers, uint32_t bounce, const Uses& uses) {
    const uint32_t dimension = BounceDimension(bounce);
    const size_t count = samplers.size();
    uses_ = uses;
    const auto pairs = FirstOf(&directions_, count);
    Sampler::Get2D(samplers, dimension + kDirection, pairs);
    SampleCosineHemisphere(pairs, FirstOf(&on_hemisphere_, count));
    if (uses.light_point) {
      Sampler::Get2D(samplers, dimension + kLightPoint, FirstOf(&light_points_, count));
    }
    if (uses.light_choice) {
      Sampler::Get1D(samplers, dimension + kLightChoice, FirstOf(&light_choices_, count));
    }
    if (uses.roulette) {
      Sampler::Get1D(samplers, dimension + kRoulette, FirstOf(&roulettes_, count));
    }
  }

  /// Those of the path whose sampler is at that place in the list.
  BounceNumbers operator[](size_t i) const {
    BounceNumbers numbers;
    numbers.direction = {directions_[i], on_hemisphere_[i]};
    if (uses_.light_point) numbers.light_point = light_points_[i];
    if (uses_.light_choice) numbers.light_choice = light_choices_[i];
    if (uses_.roulette) numbers.roulette = roulettes_[i];
    return numbers;
  }

 private:
  Uses uses_{};
  std::vector<Vec2> directions_, light_points_;
  std::vector<Vec3> on_hemisphere_;
  std::vector<float> light_choices_, roulettes_;
};

}  // namespace candela
