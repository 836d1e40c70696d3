#pragma once

#include "math/elementary.h"
#include "math/spectrum.h"

namespace candela {

/// The part of the light that a way through a medium leaves: Beer's law.
inline Spectrum Transmittance(Rgb absorption, float distance) {
  return Spectrum(Rgb{Exp(-absorption.x * distance), Exp(-absorption.y * distance),
                      Exp(-absorption.z * distance)});
}

/// Of a way without end: only what the medium does not absorb at all comes through.
inline Spectrum EndlessTransmittance(Rgb absorption) {
  const auto left = [](float a) { return a > 0 ? 0.0f : 1.0f; };
  return Spectrum(Rgb{left(absorption.x), left(absorption.y), left(absorption.z)});
}

}  // namespace candela
