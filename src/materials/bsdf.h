#pragma once

#include "base/check.h"
#include "materials/lobe.h"
#include "math/frame.h"
#include "math/spectrum.h"
#include "math/vec.h"

namespace candela {

struct Medium;

/// How light is scattered at one point. Trivially copyable; lives on the stack while a hit is
/// shaded. Directions are unit vectors in world space that point away from the surface.
struct Bsdf {
  static constexpr int kMostLobes = 4;

  Frame frame;  ///< Its z axis is the shading normal on the side of the ray that hit.
  /// What is on that side and beyond, where a scene says what fills objects; else null: then the
  /// material knows its own, which it has against air.
  const Medium *medium_here = nullptr, *medium_beyond = nullptr;
  /// That of the light in nanometres; 0 for all of it. Set by the material: whether light of other
  /// wavelengths would be scattered elsewhere.
  float wavelength = 0;
  bool is_dispersive = false;
  int count = 0;
  float pick_sum = 0;
  Lobe lobes[kMostLobes];

  Bsdf() {}  // Written out: the implicit one would clear all of it first, for each hit.

  void Add(const Lobe& lobe) {
    DCHECK(count < kMostLobes);
    lobes[count++] = lobe;
    pick_sum += lobe.pick;
  }

  /// Makes those from `first` on a part of a mixture: they do `mixed_share` of what they did, and
  /// are drawn as often.
  void Mix(int first, float mixed_share) {
    float picks = 0;
    for (int i = first; i < count; ++i) picks += lobes[i].pick;
    for (int i = first; i < count; ++i) {
      lobes[i].share *= mixed_share;
      lobes[i].pick *= picks > 0 ? mixed_share / picks : 0;
    }
    pick_sum += (picks > 0 ? mixed_share : 0) - picks;
  }

  /// Whether no light goes through to the other side.
  bool IsOpaque() const {
    for (int i = 0; i < count; ++i) {
      if (candela::LetsThrough(lobes[i].kind)) return false;
    }
    return true;
  }

  /// Whether light goes into more than single directions: whether `Eval` and `Pdf` can be above 0.
  bool HasSmoothPart() const {
    for (int i = 0; i < count; ++i) {
      if (!IsDelta(lobes[i].kind)) return true;
    }
    return false;
  }
};

/// A direction drawn from a Bsdf. `weight` is value times cosine over density.
struct BsdfSample {
  Vec3 wi;
  Spectrum weight;
  float pdf = 0;  ///< Per solid angle; 0 when nothing can be drawn.
  /// The direction is the only one of its lobe: no density over solid angle. `pdf` is then the
  /// probability of the choice, and `weight` what is reflected or let through, over `pdf`.
  bool is_delta = false;
  bool is_transmission = false;  ///< `wi` and `wo` lie on different sides of the surface.
  bool enters = false;           ///< And it gets into another body: not by a hole or a pane.
  bool is_hole = false;          ///< Nothing is there: `wi` is -`wo`, and the surface no event.
  /// The refractive index on the side of `wi` over that on the side of `wo`. Radiance is carried,
  /// so light that gets into glass is weaker by its square and recovers when it leaves again:
  /// `weight` times the square is the share of the power, which Russian roulette should look at.
  float eta = 1;
};

/// The value for light that comes from `wi` and leaves to `wo`, per steradian, without the cosine.
/// Lobes of single directions are left out.
Spectrum Eval(const Bsdf& bsdf, Vec3 wo, Vec3 wi);

/// The value, and the density with which `Sample` draws `wi`, in less time than that of both calls.
struct BsdfValue {
  Spectrum value;
  float pdf;
};
BsdfValue EvalWithPdf(const Bsdf& bsdf, Vec3 wo, Vec3 wi);

/// Draws `wi` for a given `wo`.
BsdfSample Sample(const Bsdf& bsdf, Vec3 wo, DirectionNumbers numbers);

/// The density with which `Sample` draws `wi`, per solid angle; lobes of single directions are left
/// out, so that it integrates to the share of the others.
float Pdf(const Bsdf& bsdf, Vec3 wo, Vec3 wi);

}  // namespace candela
