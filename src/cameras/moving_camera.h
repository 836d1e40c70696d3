#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cameras/camera.h"
#include "cameras/camera_motion.h"

namespace candela {

/// A camera of some kind that moves: at each time it is one of that kind, made for it. A kind says
/// what it is by `spec`, and what it is elsewhere by `SeenFrom`.
template <class Kind>
class MovingCamera final : public Camera {
 public:
  MovingCamera(const Kind& begin, const CameraMotion& motion) : begin_(begin), motion_(motion) {}

  Ray GenerateRay(Vec2 image_point) const override { return begin_.GenerateRay(image_point); }
  Ray GenerateRay(Vec2 image_point, Vec2 u) const override {
    return begin_.GenerateRay(image_point, u);
  }
  std::optional<CameraConnection> Connect(Vec3 p, Vec2 u) const override {
    return begin_.Connect(p, u);
  }
  float DepthOf(Vec3 p) const override { return begin_.DepthOf(p); }

  bool IsMoving() const override { return true; }
  std::unique_ptr<Camera> Moving(const CameraMotion& motion) const override {
    return begin_.Moving(motion);
  }
  Ray GenerateRayAt(float time, Vec2 image_point, std::optional<Vec2> u) const override {
    return At(time).GenerateRayAt(time, image_point, u);
  }
  std::optional<CameraConnection> ConnectAt(float time, Vec3 p, Vec2 u) const override {
    return At(time).Connect(p, u);
  }
  float DepthAt(float time, Vec3 p) const override { return At(time).DepthOf(p); }

  bool Repeats() const override { return begin_.Repeats(); }
  void AddRepeats(Vec2 image_point, std::vector<Vec2>* others) const override {
    begin_.AddRepeats(image_point, others);
  }
  CameraFootprint FootprintPerUnit() const override { return begin_.FootprintPerUnit(); }
  std::optional<float> CosineOnFlatFilm(Vec2 image_point) const override {
    return begin_.CosineOnFlatFilm(image_point);
  }
  bool IsPinhole() const override { return begin_.IsPinhole(); }
  bool IsInOnePlace() const override { return false; }
  std::string Description() const override { return begin_.Description() + ", moving"; }

 private:
  Kind At(float time) const { return begin_.SeenFrom(motion_.At(begin_.spec(), time)); }

  Kind begin_;
  CameraMotion motion_;
};

}  // namespace candela
