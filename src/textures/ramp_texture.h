#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "scene_spec/param_reader.h"
#include "textures/solid_place.h"
#include "textures/texture.h"
#include "textures/texture_input.h"

namespace candela {

/// Colours at stops, and between them what lies between, over a texture or along an axis.
class RampTexture final : public Texture {
 public:
  struct Stop {
    float at;
    Rgb color;
  };
  enum class Blend : uint8_t {
    kLinear,
    kSmooth,  ///< Without a crease at the stops.
    kStep,    ///< Each colour up to the next stop.
  };
  /// How the ramp goes on before 0 and behind 1, along an axis.
  enum class Wrap : uint8_t { kClamp, kRepeat, kMirror };

  /// Along an axis of a space.
  struct Along {
    SolidPlace place;
    int axis;
    Wrap wrap;
  };

  /// At least one stop, in ascending order. Over the mean of `input` where that is a texture.
  RampTexture(std::vector<Stop> stops, Blend blend, NumberInput input, const Along& along)
      : stops_(std::move(stops)), blend_(blend), input_(std::move(input)), along_(along) {}
  static std::shared_ptr<const Texture> Create(ParamReader* params, const TextureContext& context);

  Rgb Lookup(const SurfacePoint& point) const override;
  bool NeedsTextureCoordinates() const override {
    return !input_.IsTextured() || input_.NeedsTextureCoordinates();
  }

 private:
  float PositionOf(const SurfacePoint& point) const;

  std::vector<Stop> stops_;
  Blend blend_;
  NumberInput input_;
  Along along_;
};

}  // namespace candela
