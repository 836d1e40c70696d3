#pragma once

#include <span>
#include <string_view>

#include "math/spectrum.h"

namespace candela {

/// A metal with its complex refractive index eta + i k for red, green and blue.
struct Metal {
  std::string_view name;
  Rgb eta, k;
};

/// The metals that scenes may name. Measured spectra, averaged with the colour matching functions:
/// the table of the renderer Tungsten for the elements, that of Mitsuba for brass, and for iron
/// Lagarde, "Feeding a physically based shading model", 2012.
std::span<const Metal> Metals();

}  // namespace candela
