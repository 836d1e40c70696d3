#include "lights/light_tree_builder.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace candela {
namespace {

constexpr int kBins = 12;
// From this depth on parts are halved by number: at most 31 times, as there are lights.
constexpr uint32_t kDeepestByCost = 32;

Vec3d CenterOf(const LightCluster& light) {
  return (ToDouble(light.box.min) + ToDouble(light.box.max)) * 0.5;
}

int BinOf(double place, double min, double extent) {
  return std::clamp(static_cast<int>(kBins * ((place - min) / extent)), 0, kBins - 1);
}

}  // namespace

LightTreeBuilder::LightTreeBuilder(std::span<const LightReach> lights) : order_(lights.size()) {
  lights_.reserve(lights.size());
  centers_.reserve(lights.size());
  for (const LightReach& reach : lights) {
    lights_.push_back(LightCluster::Of(reach));
    centers_.push_back(CenterOf(lights_.back()));
  }
  std::iota(order_.begin(), order_.end(), 0u);
}

LightTreeBuilder::Part LightTreeBuilder::Root() const {
  return PartOf(0, static_cast<uint32_t>(order_.size()), 0);
}

LightTreeBuilder::Part LightTreeBuilder::PartOf(uint32_t begin, uint32_t end,
                                                uint32_t depth) const {
  Part part{begin, end, depth, {}};
  for (uint32_t i = begin; i < end; ++i) part.cluster.Add(lights_[order_[i]]);
  return part;
}

LightTreeBuilder::Range LightTreeBuilder::RangeOf(const Part& part) const {
  Range range{centers_[order_[part.begin]], centers_[order_[part.begin]]};
  for (uint32_t i = part.begin; i < part.end; ++i) {
    const Vec3d center = centers_[order_[i]];
    for (int axis = 0; axis < 3; ++axis) {
      range.min[axis] = std::min(range.min[axis], center[axis]);
      range.max[axis] = std::max(range.max[axis], center[axis]);
    }
  }
  return range;
}

LightTreeBuilder::Plane LightTreeBuilder::BestPlane(const Part& part, const Range& range) const {
  Plane best;
  double least = std::numeric_limits<double>::infinity();
  const Vec3d extents = range.max - range.min;
  const double longest = std::max({extents.x, extents.y, extents.z});
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = extents[axis];
    if (!(extent > 0)) continue;
    std::array<LightCluster, kBins> bins;
    for (uint32_t i = part.begin; i < part.end; ++i) {
      const uint32_t light = order_[i];
      const int bin = BinOf(centers_[light][axis], range.min[axis], extent);
      bins[static_cast<size_t>(bin)].Add(lights_[light]);
    }
    // The costs of what is before each plane, then of what is behind it.
    std::array<double, kBins> before{};
    LightCluster sum;
    for (size_t i = 0; i + 1 < kBins; ++i) {
      if (!bins[i].box.IsEmpty()) sum.Add(bins[i]);
      const bool is_new = i == 0 || !bins[i].box.IsEmpty();
      before[i + 1] = is_new ? sum.Cost() : before[i];
    }
    sum = {};
    double behind = 0;
    for (size_t i = kBins - 1; i > 0; --i) {
      if (bins[i].box.IsEmpty()) continue;
      sum.Add(bins[i]);
      behind = sum.Cost();
      // Thin slices of a short side are no better halves than they look.
      const double cost = (before[i] + behind) * (longest / extent);
      if (!(cost < least)) continue;
      least = cost;
      best = {axis, static_cast<int>(i)};
    }
  }
  return best;
}

std::pair<LightTreeBuilder::Part, LightTreeBuilder::Part> LightTreeBuilder::Split(
    const Part& part) {
  const Range range = RangeOf(part);
  const auto begin = order_.begin() + part.begin, end = order_.begin() + part.end;
  uint32_t middle = part.begin;
  if (part.depth < kDeepestByCost) {
    if (const Plane plane = BestPlane(part, range); plane.bin > 0) {
      const double min = range.min[plane.axis], extent = range.max[plane.axis] - min;
      const auto behind = std::stable_partition(begin, end, [&](uint32_t light) {
        return BinOf(centers_[light][plane.axis], min, extent) < plane.bin;
      });
      middle = static_cast<uint32_t>(behind - order_.begin());
    }
  }
  // Lights that all are in one place, or lie so that planes would divide them for ever.
  if (middle == part.begin) middle = part.begin + part.Count() / 2;
  return {PartOf(part.begin, middle, part.depth + 1), PartOf(middle, part.end, part.depth + 1)};
}

}  // namespace candela
