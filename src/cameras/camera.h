#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/ray.h"
#include "math/vec.h"

namespace candela {

/// What a point needs to know to send light to the camera.
struct CameraConnection {
  Vec3 direction;    ///< Unit vector from the point to the lens,
  float distance;    ///< and how far it is.
  Vec2 image_point;  ///< Where light from there is seen.
  float importance;  ///< The area of the image plane per area across `direction` at the point: what
                     ///< turns power that is sent to the camera, per solid angle, into radiance
                     ///< over the image plane, as a density over its area.
};

/// The cone that a ray stands for, for each unit of distance between image points: how wide it is
/// at its start, and how much wider it gets per unit of length. Near the middle of the picture.
struct CameraFootprint {
  float width = 0, spread = 0;
};

struct CameraMotion;

/// The part of the time from 0 to 1 in which the camera is open to light.
struct Shutter {
  float open = 0, close = 1;  ///< 0 <= open <= close <= 1; light is gathered evenly in between.

  /// For a number in [0, 1].
  float TimeOf(float u) const { return open + (close - open) * u; }
};

/// What sends rays through the points of an image plane, where y goes upwards and -1 and 1 are the
/// lower and the upper edge of the picture; x has the same unit. Immutable; called concurrently.
class Camera {
 public:
  virtual ~Camera() = default;

  /// The ray of an image point, through the middle of the lens where there is one, with a unit
  /// vector as its direction. Where the image point shows nothing, as beyond the circle of a
  /// fisheye, the direction is 0, and there is nothing to be traced.
  virtual Ray GenerateRay(Vec2 image_point) const = 0;

  /// The same for many image points in less time: into as many `rays`. True when it is certain that
  /// each of them shows something.
  virtual bool GenerateRays(std::span<const Vec2> image_points, Ray* rays) const {
    for (const Vec2 image_point : image_points) *rays++ = GenerateRay(image_point);
    return false;
  }

  /// The ray of an image point through a point of the lens, drawn with two numbers in [0, 1): it
  /// meets the ray through the middle where that is in focus.
  virtual Ray GenerateRay(Vec2 image_point, Vec2 /*u*/) const { return GenerateRay(image_point); }

  /// The way from the point `p` to the camera, through a point of the lens that is drawn with two
  /// numbers in [0, 1) as `GenerateRay` does. Nothing when no image point shows `p` through it. The
  /// inverse of `GenerateRay`: the ray through that image point with the same numbers meets `p`.
  virtual std::optional<CameraConnection> Connect(Vec3 p, Vec2 u) const = 0;

  /// Whether the picture goes on around, so that things are seen at several image points;
  /// `Connect` gives one of them.
  virtual bool Repeats() const { return false; }
  /// The others, for a camera that repeats: appended.
  virtual void AddRepeats(Vec2 /*image_point*/, std::vector<Vec2>* /*others*/) const {}

  /// How far away a point is: ahead of the camera along the direction of view, or from its centre
  /// where it looks to all sides.
  virtual float DepthOf(Vec3 p) const = 0;

  /// Whether it moves. Then the functions above speak of its place at time 0.
  virtual bool IsMoving() const { return false; }
  /// The same at a time in [0, 1]. A ray without a point of the lens goes through the middle of it;
  /// its own time is for the caller to set.
  virtual Ray GenerateRayAt(float /*time*/, Vec2 image_point, std::optional<Vec2> u) const {
    return u ? GenerateRay(image_point, *u) : GenerateRay(image_point);
  }
  virtual std::optional<CameraConnection> ConnectAt(float /*time*/, Vec3 p, Vec2 u) const {
    return Connect(p, u);
  }
  virtual float DepthAt(float /*time*/, Vec3 p) const { return DepthOf(p); }
  /// The same camera, moving.
  virtual std::unique_ptr<Camera> Moving(const CameraMotion& motion) const = 0;

  const Shutter& shutter() const { return shutter_; }
  void set_shutter(const Shutter& shutter) { shutter_ = shutter; }

  virtual CameraFootprint FootprintPerUnit() const = 0;

  /// The cosine of the angle between the ray of an image point and the axis of the lens, for a
  /// camera whose lens has a flat film behind it; nothing for others.
  virtual std::optional<float> CosineOnFlatFilm(Vec2 /*image_point*/) const { return std::nullopt; }

  /// Whether each image point has one ray, for want of a lens.
  virtual bool IsPinhole() const { return true; }
  /// Whether rays start in one point, or so near to it that what is around one is around all.
  virtual bool IsInOnePlace() const { return true; }

  /// Where it stands and what it sees, in words.
  virtual std::string Description() const = 0;

 private:
  Shutter shutter_;
};

}  // namespace candela
