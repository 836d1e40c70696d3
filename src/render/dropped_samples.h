#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "math/spectrum.h"

namespace candela {

/// Samples that are left out of a picture because what they saw is no light: how many, and the
/// first ones of the picture, row after row, whoever rendered them.
class DroppedSamples {
 public:
  struct Sample {
    int x = 0, y = 0;  ///< The pixel in the whole picture.
    uint32_t index = 0;
    Rgb radiance;
  };
  static constexpr size_t kMostNamed = 5;

  DroppedSamples() = default;
  /// So many, of which these are the first.
  DroppedSamples(uint64_t count, std::vector<Sample> first)
      : count_(count), first_(std::move(first)) {}

  void Add(const Sample& sample);
  DroppedSamples& operator+=(const DroppedSamples& other);

  uint64_t Count() const { return count_; }
  /// At most `kMostNamed`.
  const std::vector<Sample>& First() const { return first_; }

 private:
  void Insert(const Sample& sample);

  uint64_t count_ = 0;
  std::vector<Sample> first_;
};

}  // namespace candela
