#include "cameras/camera_spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "math/elementary.h"

namespace candela {
namespace {

std::string ToText(Vec3 v) {
  return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z);
}

void ReadBlades(ParamReader* params, CameraSpec* spec) {
  constexpr int kMostBlades = 100;
  if (params->Has("blades")) {
    const int64_t blades = params->RequiredInteger("blades").value_or(0);
    if (blades == 0 || (blades >= 3 && blades <= kMostBlades)) {
      spec->blades = static_cast<int>(blades);
    } else {
      params->Error(params->Where("blades"),
                    fmt::format("'blades' expects 3 to {}, or 0 for a round opening, found '{}'",
                                kMostBlades, blades));
    }
  }
  if (!params->Has("blade_rotation")) return;
  spec->blade_rotation = params->Number("blade_rotation", 0);
  if (params->Has("blades") && spec->blades > 0) return;
  params->Error(params->Where("blade_rotation"),
                "'blade_rotation' turns 'blades', of which there are none");
}

}  // namespace

void ReadView(ParamReader* params, CameraSpec* spec) {
  spec->center = params->RequiredVector("center");
  spec->direction = params->RequiredDirection("direction");
  spec->up = params->RequiredDirection("up");
}

bool HasUp(const CameraSpec& spec) {
  const Vec3d direction = Normalize(ToDouble(spec.direction));
  return Length(Cross(direction, Normalize(ToDouble(spec.up)))) >= 1e-7;
}

void ReadLens(ParamReader* params, CameraSpec* spec) {
  spec->aperture = params->NonNegative("aperture", 0);
  spec->focus_distance = params->Positive("focus_distance", 1);
  // Without a distance the picture would be sharp where nobody has asked for it.
  if (spec->aperture > 0 && !params->Has("focus_distance")) {
    params->Error(params->Where("aperture"), "a camera with an 'aperture' needs 'focus_distance'");
  }
  ReadBlades(params, spec);
}

// The plane that is sharp is at the distance F + x tan X + y tan Y, which is least F - r times the
// length of the two tangents on a lens of radius r.
void ReadTilt(ParamReader* params, CameraSpec* spec) {
  if (!params->Has("tilt")) return;
  const Vec2 tilt = params->Pair("tilt", {});
  const SourceLocation where = params->Where("tilt");
  if (!(std::max(std::abs(tilt.x), std::abs(tilt.y)) < 90)) {
    params->Error(where, fmt::format("'tilt' expects two angles between -90 and 90 degrees, found "
                                     "'{} {}'",
                                     tilt.x, tilt.y));
    return;
  }
  if (spec->aperture == 0) {
    params->Error(where, "'tilt' is for a lens: it needs an 'aperture' above 0");
    return;
  }
  const double slope_x = TanDegrees(double{tilt.x}), slope_y = TanDegrees(double{tilt.y});
  const double steepest = std::sqrt(slope_x * slope_x + slope_y * slope_y);
  if (spec->aperture / 2.0 * steepest < 0.99 * static_cast<double>(spec->focus_distance)) {
    spec->tilt = tilt;
  } else {
    params->Error(where,
                  "'tilt' leads the plane that is sharp through the lens: a smaller angle, "
                  "a smaller 'aperture' or a larger 'focus_distance' keeps it away");
  }
}

std::string DescribeView(const CameraSpec& spec) {
  return fmt::format("at {}, direction {}, up {}", ToText(spec.center), ToText(spec.direction),
                     ToText(spec.up));
}

Frame AxesOf(const CameraSpec& spec) {
  const Vec3 view = NormalizeAnyLength(spec.direction);
  const Vec3 right = NormalizeAnyLength(Cross(view, NormalizeAnyLength(spec.up)));
  return {right, Cross(right, view), view};
}

}  // namespace candela
