#pragma once

#include "cameras/camera_spec.h"
#include "math/vec.h"

namespace candela {

/// A thin lens with an opening that is round or a regular polygon, and the plane that it shows
/// sharply.
class Lens {
 public:
  explicit Lens(const CameraSpec& spec);

  bool IsPinhole() const { return radius_ == 0; }

  /// A point of the opening, seen from its middle, drawn with two numbers in [0, 1).
  Vec3 PointAt(Vec2 u) const;

  float focus_distance() const { return focus_distance_; }
  Vec3 view() const { return axes_.z; }

  /// What lies at `d` from the middle is in focus when its product with this vector is the distance
  /// of focus: the direction of view, unless the plane is tilted.
  Vec3 focus_normal() const { return focus_normal_; }
  bool IsTilted() const { return is_tilted_; }

 private:
  Vec2 Sample(Vec2 u) const;
  /// The corner of the polygon of that number, in units of the radius.
  Vec2 Corner(int i) const;

  Frame axes_;
  float radius_;
  int blades_;
  float blade_rotation_;
  float focus_distance_;
  Vec3 focus_normal_;
  bool is_tilted_;
};

}  // namespace candela
