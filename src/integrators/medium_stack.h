#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geometry/surface_point.h"
#include "math/spectrum.h"
#include "scene/interior.h"
#include "scene/scene.h"

namespace candela {

/// The bodies that light is in, by their interiors, and what that makes of their surfaces: Schmidt
/// and Budge, "Simple Nested Dielectrics in Ray Traced Images", 2002. Where bodies overlap, the one
/// of the greatest priority fills the place, and the surfaces of the others are not there.
class MediumStack {
 public:
  /// In so many bodies light can be at once; further ones are left out.
  static constexpr uint32_t kMost = 4;

  bool IsEmpty() const { return count_ == 0; }
  bool IsFull() const { return count_ == kMost; }

  /// What the place is filled with.
  Rgb Absorption(std::span<const Interior> interiors) const {
    return IsEmpty() ? Rgb() : interiors[Top(interiors)].medium.absorption;
  }
  const Medium& SeenMedium(std::span<const Interior> interiors) const {
    return IsEmpty() ? kAir : interiors[Top(interiors)].SeenMedium();
  }

  /// Into a body, and out of it; leaving one that light is not in changes nothing.
  void Enter(uint32_t interior) {
    if (!IsFull()) entered_[count_++] = interior;
  }
  void Leave(uint32_t interior);

  bool Contains(uint32_t interior) const;

  /// Whether the surface of a body, which light with this stack meets, lies hidden in another one.
  bool Hides(std::span<const Interior> interiors, uint32_t interior, bool enters) const;

 private:
  /// Of those with the greatest priority the last one. There has to be one.
  uint32_t Top(std::span<const Interior> interiors) const;

  std::array<uint32_t, kMost> entered_{};  ///< The first `count_` of them, in their order.
  uint32_t count_ = 0;
};

/// The bodies around a point at a time, found by the surfaces that are met along a line through it.
MediumStack MediaAround(const Scene& scene, Vec3 p, float time);

}  // namespace candela
