#pragma once

#include <cstdint>
#include <string>

namespace candela::determinism {

/// The text of a small scene with everything that has a formula of its own: spheres, planes and
/// triangles below nested transforms, point and directional lights, mirrors and highlights. The
/// same text for the same seed, everywhere.
std::string RandomScene(uint32_t seed);

/// One for `whitted` with all that takes it several rays: a lens, fog, lamps with a surface, glass,
/// and reflections that are spread.
std::string RandomDistributionScene(uint32_t seed);

/// Where those begin that an integrator follows. From lights they need a floor that ends, and
/// bodies of different priorities where they overlap.
enum class Paths { kFromCamera, kFromLights };

/// One that integrators of light transport take: diffuse surfaces, a sphere that shines, a grey
/// sky.
std::string RandomDiffuseScene(uint32_t seed, Paths paths);

}  // namespace candela::determinism
