#pragma once

#include <vector>

#include "bench_scene.h"
#include "geometry/ray.h"
#include "kernel/group.h"

namespace candela {

/// From the pinhole of a view, row by row.
std::vector<Ray> CameraRays(const View& view, int side);

/// From where other rays hit to where they do not agree on: each towards the hit of another one.
std::vector<Ray> ScatteredRays(const Group& group, const std::vector<Ray>& camera_rays);

/// The least of several times that a search for the nearest hits takes.
double NanosecondsPerRay(const Group& group, RayOrder order, const std::vector<Ray>& rays,
                         int repetitions);

}  // namespace candela
