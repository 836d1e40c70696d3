#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cameras/camera.h"
#include "cameras/camera_spec.h"

namespace candela {

/// How the distance from the middle of a fisheye's picture grows with the angle to the direction of
/// view: Kannala and Brandt, "A Generic Camera Model and Calibration Method for Conventional,
/// Wide-Angle, and Fish-Eye Lenses", 2006.
enum class FisheyeMapping {
  kEquidistant,  ///< With the angle itself.
  kEquisolid,    ///< With the sine of half of it: equal areas for equal solid angles.
};

/// A camera that shows up to all directions in a circle as high as the picture. Beyond the circle
/// there is nothing.
class FisheyeCamera final : public Camera {
 public:
  /// The field of view of `spec`, the angle across the circle, is above 0 and at most 360 degrees.
  FisheyeCamera(const CameraSpec& spec, FisheyeMapping mapping);
  static std::unique_ptr<Camera> Create(ParamReader* params, CameraSpec view);

  using Camera::GenerateRay;
  Ray GenerateRay(Vec2 image_point) const override;
  std::optional<CameraConnection> Connect(Vec3 p, Vec2 u) const override;
  float DepthOf(Vec3 p) const override { return Length(p - spec_.center); }
  CameraFootprint FootprintPerUnit() const override;
  std::unique_ptr<Camera> Moving(const CameraMotion& motion) const override;
  std::string Description() const override;

  const CameraSpec& spec() const { return spec_; }
  /// The same kind of camera, at another place.
  FisheyeCamera SeenFrom(const CameraSpec& view) const { return FisheyeCamera(view, mapping_); }

 private:
  CameraSpec spec_;
  FisheyeMapping mapping_;
  Frame axes_;
  double half_angle_;    ///< From the middle to the rim, in radians,
  double sine_of_half_;  ///< and the sine of half of that.
};

}  // namespace candela
