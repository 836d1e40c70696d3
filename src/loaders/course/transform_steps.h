#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/diagnostics.h"
#include "math/mat4.h"
#include "scene_spec/param_set.h"

namespace candela {

/// A step of a `Transform` block that was read.
struct TransformStep {
  static constexpr size_t kMostNumbers = 12;

  size_t kind;  ///< Which of the steps it is.
  std::array<double, kMostNumbers> numbers;
};
using TransformSteps = std::vector<TransformStep>;

/// The steps of a `Transform` block, in the order they were written. Those that are wrong are
/// reported and left out.
TransformSteps ReadSteps(const ParamSet& steps, Diagnostics* diagnostics);

/// Their product: the last one acts first on the object.
Mat4 Product(const TransformSteps& steps);

/// So far something turns while it is taken to go straight on: it comes nearer to its axis by at
/// most a part in 1600 of its distance.
inline constexpr int kDegreesOfPart = 4;

/// In how many parts each way between two keyframes, of which there are some, is to be cut: one,
/// unless all have the same steps, and turn by angles. A power of two, so that the parts of nodes
/// within each other have their moments in common.
size_t PartsOfKeyframes(std::span<const TransformSteps> frames);

/// The matrices of the keyframes and, where the ways between them are cut, those in between, of
/// which each number lies evenly between those of its neighbours.
std::vector<Mat4> MatricesOfKeyframes(std::span<const TransformSteps> frames, size_t parts);

}  // namespace candela
