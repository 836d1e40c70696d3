#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cameras/camera.h"
#include "cameras/camera_spec.h"

namespace candela {

/// A camera that shows directions by longitude and latitude, as pictures of surroundings do: equal
/// distances in the picture are equal angles. A picture twice as wide as it is high holds all
/// directions when the field of view is 180 degrees. The picture goes on around beyond its edges,
/// up to a turn and a half to each side and over the poles up to the horizon.
class PanoramicCamera final : public Camera {
 public:
  /// The field of view of `spec`, from the lowest latitude to the highest, is above 0 and at most
  /// 180 degrees.
  explicit PanoramicCamera(const CameraSpec& spec);
  static std::unique_ptr<Camera> Create(ParamReader* params, CameraSpec view);

  using Camera::GenerateRay;
  Ray GenerateRay(Vec2 image_point) const override;
  std::optional<CameraConnection> Connect(Vec3 p, Vec2 u) const override;
  bool Repeats() const override { return true; }
  void AddRepeats(Vec2 image_point, std::vector<Vec2>* others) const override;
  float DepthOf(Vec3 p) const override { return Length(p - spec_.center); }
  CameraFootprint FootprintPerUnit() const override;
  std::unique_ptr<Camera> Moving(const CameraMotion& motion) const override;
  std::string Description() const override;

  const CameraSpec& spec() const { return spec_; }
  /// The same kind of camera, at another place.
  PanoramicCamera SeenFrom(const CameraSpec& view) const { return PanoramicCamera(view); }

 private:
  /// Whether the picture reaches so far.
  bool Shows(Vec2 image_point) const;

  CameraSpec spec_;
  Frame axes_;
  double angle_per_unit_;  ///< In radians.
  float half_turn_;        ///< In units of the image plane, as all lengths below.
};

}  // namespace candela
