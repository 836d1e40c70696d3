#pragma once

#include "math/vec.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// Sums of `GradientNoise` in finer and finer copies, over what they can be at most. Copies that
/// are finer than a width fade to their mean. Musgrave in Ebert et al., "Texturing and Modeling: A
/// Procedural Approach", 2003.
class FractalNoise {
 public:
  /// `gain` is how strong each copy is over the one before, `lacunarity` how fine.
  FractalNoise(int octaves, float gain, float lacunarity);
  /// Reads `octaves`, `gain` and `lacunarity`.
  static FractalNoise Create(ParamReader* params, int default_octaves);

  /// From -1 to 1, with a mean of 0: fractional Brownian motion.
  float Motion(Vec3 p, float width) const;
  /// From 0 to 1: that of the magnitudes, with creases.
  float Turbulence(Vec3 p, float width) const;

 private:
  template <class Copy>
  float Sum(Vec3 p, float width, const Copy& copy) const;

  int octaves_;
  float gain_, lacunarity_;
  float most_;
};

/// How much of a pattern is seen over a width: 1 for a narrow one, 0 for one of a period.
float DetailLeft(float width_over_period);

}  // namespace candela
