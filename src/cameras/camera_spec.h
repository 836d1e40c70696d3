#pragma once

#include <string>

#include "math/frame.h"
#include "math/vec.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// A camera as a scene describes it. What a kind of camera does not know it does not look at.
struct CameraSpec {
  Vec3 center;
  Vec3 direction{0, 0, -1};  ///< Where it looks; any length but 0.
  Vec3 up{0, 1, 0};          ///< Not parallel to `direction`, not necessarily orthogonal to it.
  float fov_degrees = 30;    ///< Full vertical angle; its range is for the kind to say.
  float aperture = 0;        ///< Diameter of the lens; 0 for a pinhole, which shows all sharply.
  float focus_distance = 1;  ///< Of the plane that is sharp, along the direction of view; above 0.
  int blades = 0;            ///< Corners of the opening, 3 or more; 0 for a round one.
  float blade_rotation = 0;  ///< Degrees by which they are turned, counter-clockwise as seen along
                             ///< the direction of view.
  Vec2 tilt{};  ///< Degrees by which the plane that is sharp recedes to the right and upwards; each
                ///< in (-90, 90), and not so far that it cuts the lens.
  Vec2 shift{};  ///< Of the picture's window in the image plane, in halves of its height.
};

/// Reads `center`, `direction` and `up`, which all cameras have.
void ReadView(ParamReader* params, CameraSpec* spec);
/// Whether `up` says which way is up: it does not when it is parallel to `direction`.
bool HasUp(const CameraSpec& spec);
/// Reads what a lens has: `aperture`, `focus_distance`, `blades` and `blade_rotation`.
void ReadLens(ParamReader* params, CameraSpec* spec);
/// Reads `tilt`, for a lens that has been read.
void ReadTilt(ParamReader* params, CameraSpec* spec);

/// "at 0 0 10, direction 0 0 -1, up 0 1 0".
std::string DescribeView(const CameraSpec& spec);

/// The axes of a camera: x to the right, y upwards and z along the direction of view, unit vectors
/// at right angles whatever the length and the slant of `up`.
Frame AxesOf(const CameraSpec& spec);

}  // namespace candela
