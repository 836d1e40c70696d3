#pragma once

#include <algorithm>
#include <bit>
#include <cmath>

#include "kernel/search.h"

namespace candela::kernel {

/// Sixteen rays side by side, prepared for boxes and triangles with the very numbers that
/// `SpaceRay` has for each, and bounds on them. Only for rays that go the same way: the signs of
/// their directions, and the axis that they follow most, are the same.
template <class L>
struct PacketRays {
  static constexpr int kRays = 16;

  /// Bounds on origins and reciprocals, wider than the slack of any ray.
  struct Frustum {
    float near_origin[3], far_origin[3], low_slope[3], high_slope[3];
  };

  uint32_t near_row[3];
  int kx, ky, kz;
  float nearest_t_min;
  float farthest;  ///< The largest coordinate of origins and of the group, by magnitude.
  Frustum frustum;
  alignas(64) float near_scale[3][kRays], near_offset[3][kRays];
  alignas(64) float far_scale[3][kRays], far_offset[3][kRays];
  alignas(64) float origin[3][kRays], shear[2][kRays], t_min[kRays];

  /// Takes the rays of searches that have begun, one for each bit of `active`; other lanes repeat
  /// the first of them. False when they go different ways or have unusual numbers.
  bool Set(const Search<L>* searches, uint32_t active, float largest) {
    alignas(64) float direction[3][kRays];
    const int first = std::countr_zero(active);
    for (int i = 0; i < kRays; ++i) {
      const Search<L>& search = searches[active >> i & 1 ? i : first];
      for (int axis = 0; axis < 3; ++axis) {
        origin[axis][i] = search.asked->origin[axis];
        direction[axis][i] = search.asked->direction[axis];
      }
      t_min[i] = search.t_min;
    }
    if (!FollowOneAxis(direction)) return false;
    P reach = P::Broadcast(largest);
    for (int axis = 0; axis < 3; ++axis) reach = Max(reach, Abs(P::Load(origin[axis])));
    alignas(64) float reaches[kRays];
    reach.Store(reaches);
    farthest = Greatest(reaches);
    if (!(farthest <= SpaceRay::kUsualCoordinate)) return false;
    uint32_t usual = kAllRays;
    for (int axis = 0; axis < 3; ++axis) usual &= SetAxis(axis, direction[axis]);
    if (usual != kAllRays) return false;

    const Ray& ray = *searches[first].asked;
    const ShearedRay sheared(ray);
    kx = sheared.kx, ky = sheared.ky, kz = sheared.kz;
    const P along = P::Load(direction[kz]), minus = P::Broadcast(-1);
    (P::Load(direction[kx]) / along * minus).Store(shear[0]);
    (P::Load(direction[ky]) / along * minus).Store(shear[1]);
    nearest_t_min = Least(t_min);
    for (int axis = 0; axis < 3; ++axis) SetFrustum(axis);
    return true;
  }

  /// A ray as the tests of triangles want it.
  void StoreSheared(int i, const Ray& ray, ShearedRay* sheared) const {
    sheared->origin = ray.origin;
    sheared->direction = ray.direction;
    sheared->kx = kx, sheared->ky = ky, sheared->kz = kz;
    sheared->origin_x = origin[kx][i];
    sheared->origin_y = origin[ky][i];
    sheared->origin_z = origin[kz][i];
    sheared->shear_x = shear[0][i];
    sheared->shear_y = shear[1][i];
  }

  static float Least(const float (&all)[kRays]) {
    return Reduce(all, [](float a, float b) { return a < b ? a : b; });
  }
  static float Greatest(const float (&all)[kRays]) {
    return Reduce(all, [](float a, float b) { return a > b ? a : b; });
  }

 private:
  using P = typename L::Packet;
  static constexpr uint32_t kAllRays = 0xFFFF;

  static bool AreSame(uint32_t bits) { return bits == 0 || bits == kAllRays; }
  [[gnu::always_inline]] static P Abs(P a) { return Max(a, P::Broadcast(0) - a); }

  /// Whether the largest component of all directions is the same.
  [[gnu::always_inline]] static bool FollowOneAxis(const float (&direction)[3][kRays]) {
    const P x = Abs(P::Load(direction[0])), y = Abs(P::Load(direction[1]));
    const P z = Abs(P::Load(direction[2]));
    return AreSame((y <= x).Bits()) && AreSame((z <= Max(x, y)).Bits());
  }

  /// What `SpaceRay` does for one ray. Returns the rays of usual numbers; none when signs differ.
  [[gnu::always_inline]] uint32_t SetAxis(int axis, const float (&direction)[kRays]) {
    const P slope = P::Broadcast(1) / P::Load(direction);
    const uint32_t negative = (slope < P::Broadcast(0)).Bits();
    if (!AreSame(negative)) return 0;
    const P offset = P::Load(origin[axis]) * slope;
    const P slack =
        Abs(offset) * P::Broadcast(SpaceRay::kOffsetSlack) + P::Broadcast(SpaceRay::kLeastSlack);
    (slope * P::Broadcast(1 - SpaceRay::kScaleSlack)).Store(near_scale[axis]);
    (slope * P::Broadcast(1 + SpaceRay::kScaleSlack)).Store(far_scale[axis]);
    (offset + slack).Store(near_offset[axis]);
    (offset - slack).Store(far_offset[axis]);
    near_row[axis] = static_cast<uint32_t>(2 * axis) + (negative & 1);
    return (Abs(slope) <= P::Broadcast(SpaceRay::kUsualSlope)).Bits();
  }

  [[gnu::always_inline]] void SetFrustum(int axis) {
    constexpr float kOriginSlack = 3e-6f, kSlopeSlack = 2e-6f;
    alignas(64) float slack[kRays];
    ((P::Load(near_offset[axis]) - P::Load(far_offset[axis])) / Abs(P::Load(near_scale[axis])))
        .Store(slack);
    const float most_slack = Greatest(slack);
    float low = Least(origin[axis]), high = Greatest(origin[axis]);
    low -= std::abs(low) * kOriginSlack + most_slack;
    high += std::abs(high) * kOriginSlack + most_slack;
    const float least_slope = Least(near_scale[axis]), most_slope = Greatest(near_scale[axis]);
    const bool is_negative = most_slope < 0;
    frustum.near_origin[axis] = is_negative ? low : high;
    frustum.far_origin[axis] = is_negative ? high : low;
    frustum.low_slope[axis] = least_slope - std::abs(least_slope) * kSlopeSlack;
    frustum.high_slope[axis] = most_slope + std::abs(most_slope) * kSlopeSlack;
  }

  /// Halving by halving, which compilers turn into instructions for several lanes.
  template <class Pick>
  [[gnu::always_inline]] static float Reduce(const float (&all)[kRays], Pick pick) {
    float half[8], quarter[4];
    for (int i = 0; i < 8; ++i) half[i] = pick(all[i], all[i + 8]);
    for (int i = 0; i < 4; ++i) quarter[i] = pick(half[i], half[i + 4]);
    return pick(pick(quarter[0], quarter[1]), pick(quarter[2], quarter[3]));
  }
};

}  // namespace candela::kernel
