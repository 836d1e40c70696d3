#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cameras/camera.h"
#include "cameras/camera_spec.h"
#include "cameras/lens.h"

namespace candela {

/// A camera whose rays are parallel: things are as large however far away they are. They start in
/// the plane through the centre; what lies behind it is not seen. With an aperture each ray has a
/// thin lens of its own around its start, as one that is telecentric does.
class OrthographicCamera final : public Camera {
 public:
  /// `height` is that of what the picture shows, above 0.
  OrthographicCamera(const CameraSpec& spec, float height);
  static std::unique_ptr<Camera> Create(ParamReader* params, CameraSpec view);

  Ray GenerateRay(Vec2 image_point) const override;
  Ray GenerateRay(Vec2 image_point, Vec2 u) const override;
  std::optional<CameraConnection> Connect(Vec3 p, Vec2 u) const override;
  float DepthOf(Vec3 p) const override { return Dot(p - spec_.center, axes_.z); }
  CameraFootprint FootprintPerUnit() const override { return {half_height_, 0}; }
  bool IsPinhole() const override { return lens_.IsPinhole(); }
  bool IsInOnePlace() const override { return false; }
  std::unique_ptr<Camera> Moving(const CameraMotion& motion) const override;
  std::string Description() const override;

  const CameraSpec& spec() const { return spec_; }
  /// The same kind of camera, at another place.
  OrthographicCamera SeenFrom(const CameraSpec& view) const {
    return OrthographicCamera(view, 2 * half_height_);
  }

 private:
  CameraSpec spec_;
  Frame axes_;
  float half_height_;
  Lens lens_;
};

}  // namespace candela
