#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "cameras/camera.h"
#include "cameras/camera_spec.h"
#include "cameras/lens.h"
#include "geometry/ray.h"

namespace candela {

/// A camera after the course: `up` is used as it was given, not made orthogonal to the direction of
/// view. With an aperture it has a thin lens, which shows sharply what lies in one plane; the plane
/// may be tilted, and the window of the picture shifted in the image plane, as those of a view
/// camera are.
class PerspectiveCamera final : public Camera {
 public:
  explicit PerspectiveCamera(const CameraSpec& spec);
  static std::unique_ptr<Camera> Create(ParamReader* params, CameraSpec view);

  Ray GenerateRay(Vec2 image_point) const override {
    Ray ray(center_, Normalize(forward_ + right_ * image_point.x + up_ * image_point.y));
    ray.mask = kCameraRay;
    return ray;
  }
  bool GenerateRays(std::span<const Vec2> image_points, Ray* rays) const override;
  Ray GenerateRay(Vec2 image_point, Vec2 u) const override;
  std::optional<CameraConnection> Connect(Vec3 p, Vec2 u) const override;
  float DepthOf(Vec3 p) const override { return Dot(p - center_, lens_.view()); }
  CameraFootprint FootprintPerUnit() const override { return {0, angle_per_unit_}; }
  std::optional<float> CosineOnFlatFilm(Vec2 image_point) const override {
    return Dot(GenerateRay(image_point).direction, lens_.view());
  }
  bool IsPinhole() const override { return lens_.IsPinhole(); }
  std::unique_ptr<Camera> Moving(const CameraMotion& motion) const override;
  std::string Description() const override;

  const CameraSpec& spec() const { return spec_; }
  /// The same kind of camera, at another place.
  PerspectiveCamera SeenFrom(const CameraSpec& view) const { return PerspectiveCamera(view); }

 private:
  /// The image point that shows what lies at `way` from the centre; nothing when it is behind.
  std::optional<Vec2> ImagePointOf(Vec3d way) const;
  /// What the centre would have to see where a point of the lens, `offset` from the centre, sees
  /// what lies at `way` from it.
  Vec3d SeenFromCentre(Vec3d offset, Vec3d way) const;

  CameraSpec spec_;
  Vec3 center_;
  Vec3 forward_;     ///< From the centre to the middle of the picture's window.
  Vec3 right_, up_;  ///< From there to the edges of the field of view.
  float angle_per_unit_;
  Lens lens_;
};

}  // namespace candela
