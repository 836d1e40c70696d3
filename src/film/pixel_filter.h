#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "math/vec.h"

namespace candela {

/// A row of the table of filters: a profile that is used along x and along y.
struct PixelFilterEntry {
  std::string_view name;
  std::string_view description;
  float radius;  ///< in pixels; the profile counts as 0 beyond
  /// The height of the profile at 0 <= x <= radius, on any scale; it is mirrored for x < 0.
  double (*profile)(double x);
};

/// All filters, in the order of the manual.
std::span<const PixelFilterEntry> PixelFilters();

/// The filter of that name, or null.
const PixelFilterEntry* FindPixelFilter(std::string_view name);

/// A position around the centre of a pixel, in pixels, and what the sample taken there counts.
struct FilterSample {
  Vec2 offset;
  float weight = 1;
};

/// Chooses sample positions with the density of a reconstruction filter, so that a pixel is the
/// plain weighted mean of its own samples: M. Ernst, M. Stamminger and G. Greiner, "Filter
/// importance sampling" (2006). No sample is shared between pixels, which keeps pixels independent
/// of each other.
///
/// Where the filter is negative, positions follow its magnitude and the weight is negative; the
/// expected weight is 1. Filters without negative parts have weight 1 always.
///
/// May be used concurrently.
class PixelFilter {
 public:
  explicit PixelFilter(const PixelFilterEntry& entry);

  /// `u` in [0, 1)^2; evenly spread pairs give evenly spread positions.
  FilterSample Sample(Vec2 u) const;

  /// Its value at `offset`, with an integral of 1: the density of positions times their weight.
  float At(Vec2 offset) const;
  float Radius() const { return static_cast<float>(radius_); }

 private:
  struct AxisSample {
    double offset, weight;
  };
  AxisSample SampleAxis(float u) const;
  double AxisAt(float offset) const;

  // The magnitude of the profile over [-radius, radius] as a polyline between equidistant nodes,
  // its integral up to each node, and the sign between two nodes. The integral ends at 1.
  std::vector<double> magnitude_;
  std::vector<double> integral_;
  std::vector<double> sign_;
  // For each equal part of [0, 1) the cell in which it begins, to search from: the guide tables of
  // H. Chen and Y. Asau, "On generating random variates from an empirical distribution" (1974).
  std::vector<uint16_t> guide_;
  double radius_;
  double step_;
  double weight_;  ///< magnitude of the weight along one axis
};

}  // namespace candela
