#pragma once

#include <cstdint>

#include "base/check.h"
#include "math/frame.h"
#include "math/spectrum.h"
#include "math/vec.h"

namespace candela {

/// The kinds of reflection a surface can be composed of. A closed list: transport dispatches on it.
enum class LobeKind : uint8_t {
  kLambert,  ///< Ideally diffuse: the same radiance in all directions of the upper side.
};

/// One part of what a surface does with light. For `kLambert` the weight is the albedo.
struct Lobe {
  LobeKind kind = LobeKind::kLambert;
  Spectrum weight;
};

/// How light is scattered at one point. Trivially copyable; lives on the stack while a hit is
/// shaded. Directions are unit vectors in world space that point away from the surface.
struct Bsdf {
  static constexpr int kMostLobes = 8;

  Frame frame;  ///< Its z axis is the shading normal on the side of the ray that hit.
  int count = 0;
  Lobe lobes[kMostLobes];

  void Add(const Lobe& lobe) {
    DCHECK(count < kMostLobes);
    lobes[count++] = lobe;
  }
};

/// A direction drawn from a Bsdf. `weight` is value times cosine over density.
struct BsdfSample {
  Vec3 wi;
  Spectrum weight;
  float pdf = 0;  ///< Per solid angle; 0 when nothing can be drawn.
};

/// The value for light that comes from `wi` and leaves to `wo`, per steradian, without the cosine.
Spectrum Eval(const Bsdf& bsdf, Vec3 wo, Vec3 wi);

/// Draws `wi` for a given `wo` from two numbers in [0, 1).
BsdfSample Sample(const Bsdf& bsdf, Vec3 wo, Vec2 u);

/// The density with which `Sample` draws `wi`, per solid angle.
float Pdf(const Bsdf& bsdf, Vec3 wo, Vec3 wi);

}  // namespace candela
