#include "geometry/bounds3.h"

namespace candela {

Bounds3 TransformBounds(const Transform& transform, const Bounds3& bounds) {
  if (bounds.IsEmpty()) return bounds;
  if (!bounds.IsFinite()) return Bounds3::Infinite();
  Bounds3 image;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p{corner & 1 ? bounds.max.x : bounds.min.x, corner & 2 ? bounds.max.y : bounds.min.y,
                 corner & 4 ? bounds.max.z : bounds.min.z};
    const Vec3 error = transform.PointError(p, {});
    const Vec3 low = transform.Point(p) - error, high = transform.Point(p) + error;
    if (!IsFinite(low) || !IsFinite(high))
      return Bounds3::Infinite();  // A NaN would not extend it.
    image.Extend(low);
    image.Extend(high);
  }
  return image;
}

}  // namespace candela
