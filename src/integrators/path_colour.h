#pragma once

#include "materials/bsdf.h"
#include "math/spectrum.h"
#include "math/wavelength.h"
#include "sampling/sampler.h"

namespace candela {

/// Which light a path carries. It stands for that of all wavelengths until it meets a surface that
/// sends them different ways; from then on it is light of one.
struct PathColour {
  float wavelength = 0;   ///< In nanometres; 0 in scenes where no surface does that.
  bool is_split = false;  ///< It is light of this wavelength alone.

  void Draw(const Sampler& sampler) {
    wavelength = SampleWavelength(sampler.Get1D(kWavelengthDimension));
  }

  /// At a surface whose Bsdf is known: what is left of light of all wavelengths.
  void Split(const Bsdf& bsdf, Spectrum* throughput) {
    if (!bsdf.is_dispersive || is_split) return;
    is_split = true;
    *throughput *= ColourOf(wavelength);
  }
};

}  // namespace candela
