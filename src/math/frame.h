#pragma once

#include <cmath>

#include "math/vec.h"

namespace candela {

/// A right-handed orthonormal basis around a normal. In its local space the normal is (0, 0, 1), so
/// the cosine of a direction is its z.
struct Frame {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  /// Any basis around the unit vector `n`; it varies smoothly except across the plane z = 0. Duff
  /// et al., "Building an orthonormal basis, revisited" (JCGT 2017): choosing the sign keeps the
  /// denominator at 1 or more in magnitude, where the older formula divided by 1 + z.
  static Frame FromNormal(Vec3 n) {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    return {
        {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
  }

  /// The basis around `n` whose x axis is `tangent` without its part along `n`; any, when nothing
  /// is left of that.
  static Frame FromNormalAndTangent(Vec3 n, Vec3 tangent) {
    const Vec3 along = tangent - n * Dot(n, tangent);
    const float length2 = LengthSquared(along);
    if (!(length2 > 1e-12f * LengthSquared(tangent)) || !std::isfinite(length2)) {
      return FromNormal(n);
    }
    const Vec3 x = NormalizeAnyLength(along);
    return {x, Cross(n, x), n};
  }

  Vec3 ToLocal(Vec3 world) const { return {Dot(world, x), Dot(world, y), Dot(world, z)}; }
  Vec3 ToWorld(Vec3 local) const { return x * local.x + y * local.y + z * local.z; }
};

}  // namespace candela
