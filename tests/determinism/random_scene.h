#pragma once

#include <cstdint>
#include <string>

namespace candela::determinism {

/// The text of a small scene with everything that has a formula of its own: spheres, planes and
/// triangles below nested transforms, point and directional lights, mirrors and highlights. The
/// same text for the same seed, everywhere.
std::string RandomScene(uint32_t seed);

/// One that the path integrator takes: diffuse surfaces, a sphere that shines, a grey sky. The
/// floor is a plane, or a rectangle for integrators that follow light from the sky.
enum class Floor { kEndless, kBounded };
std::string RandomDiffuseScene(uint32_t seed, Floor floor);

}  // namespace candela::determinism
