#pragma once

#include <cstdint>
#include <string>

namespace candela {

/// The scene file of a room with two balls, lit by so many small lamps that hang all over it,
/// above what the camera sees: spheres, rectangles and disks whose radiance differs by up to a
/// thousand times.
std::string LampRoom(uint32_t lamps);

}  // namespace candela
