#pragma once

#include "lights/light.h"

namespace candela {

/// The area of the disk through which light from the sky enters a scene.
double SkyDiskArea(const Ball& scene);

/// Light that comes along the unit direction `w` from infinitely far, of which `pdf_direction` is
/// the density: it starts from a point of a disk that touches the ball and covers it, drawn evenly
/// with two numbers in [0, 1).
EmissionSample EmitFromSky(const Ball& scene, Vec3 w, float pdf_direction, const Spectrum& radiance,
                           Vec2 u);

/// The density of such points.
float SkyPositionPdf(const Ball& scene);

}  // namespace candela
