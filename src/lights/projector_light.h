#pragma once

#include <memory>
#include <mutex>

#include "lights/light.h"
#include "math/frame.h"
#include "sampling/distribution.h"
#include "scene_spec/param_reader.h"
#include "textures/texture_input.h"

namespace candela {

struct LightContext;

/// A point light that throws a picture: on a screen across its direction at distance D the picture
/// is evenly lit by color / (attenuation D^2), times what the picture has there, and dark around
/// it. So the intensity grows towards the corners by the cube of the cosine, as a slide's does.
class ProjectorLight final : public Light {
 public:
  using Light::SampleIncident;

  /// Of the light that it throws.
  struct Beam {
    Vec3 direction;  ///< Where its middle goes; any length but 0.
    Vec3 up;         ///< What is up in the picture; any length but 0, not parallel to `direction`.
    Vec2 extent;     ///< Half of the width and of the height of the picture at distance 1; above 0.
    bool is_mirrored = false;  ///< Left and right have changed places.
  };
  /// Colours below 0 in the picture count as 0. Of a picture with details finer than 1/512 of it
  /// the power is known roughly; the light is not.
  ProjectorLight(Vec3 position, const Beam& beam, ColorInput image, Rgb color, float attenuation);
  static std::unique_ptr<Light> Create(ParamReader* params, const LightContext& context);

  LightKind Kind() const override { return LightKind::kPoint; }
  LightSample SampleIncident(Vec3 p) const override;
  LightReach Reach() const override;
  EmissionSample SampleEmission(const Ball& scene, Vec2 u_position,
                                Vec2 u_direction) const override;
  EmissionPdf PdfEmission(const Ball& scene, const SurfacePoint& from, Vec3 w) const override;
  float Power(const Ball& scene) const override;

 private:
  /// Of the picture: its mean, and how densely places of emission are drawn.
  struct Overview {
    Rgb mean;
    Distribution2D distribution;
  };
  /// Made when it is asked for first: many scenes never do, and it takes many lookups.
  const Overview& TheOverview() const;

  /// Where a direction goes through the picture, with the cosine to its middle; a cosine of 0 where
  /// it does not.
  struct Place {
    Vec2 uv;
    float cosine;
  };
  Place PlaceOf(Vec3 direction) const;
  /// What the picture shows there, v upwards.
  Rgb ImageAt(Vec2 uv) const;
  /// The density of places of emission, over the unit square.
  float PdfOfPlace(Vec2 uv) const;
  float Area() const { return 4 * extent_.x * extent_.y; }  ///< Of the picture at distance 1.

  Vec3 position_;
  Frame frame_;  ///< Right and up in the picture, and the direction.
  Vec2 extent_;
  ColorInput image_;
  Rgb intensity_;  ///< In the middle, of a white picture.
  mutable std::once_flag is_looked_at_;
  mutable std::unique_ptr<const Overview> overview_;
};

}  // namespace candela
