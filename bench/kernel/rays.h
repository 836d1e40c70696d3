#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "bench_scene.h"
#include "embree_scene.h"
#include "geometry/ray.h"

namespace candela {

/// Rays as a renderer sends them.
enum class RaySet {
  kPrimary,  ///< From a pinhole; 16 in a row are a tile of 4 x 4 pixels.
  kDiffuse,  ///< The first bounce of a path, by the cosine, pixel after pixel.
  kDeep,     ///< The fourth bounce, in no order within a wavefront of 65,536.
  kShadow,   ///< From where the primary rays hit to a point of the light: is anything in between?
};
inline constexpr std::array kRaySets = {RaySet::kPrimary, RaySet::kDiffuse, RaySet::kDeep,
                                        RaySet::kShadow};

std::string_view RaySetName(RaySet set);
std::optional<RaySet> FindRaySet(std::string_view name);

/// Makes side * side rays of a set, `side` a power of two. What Embree hits decides how paths go
/// on. Pixels whose path ends too early are left out, and made up for by further rounds over
/// the picture; fails when there are hardly any others.
Result<std::vector<Ray>> MakeRays(RaySet set, const BenchScene& scene, const EmbreeScene& embree,
                                  int side);

}  // namespace candela
