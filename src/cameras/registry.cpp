#include "cameras/registry.h"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "cameras/camera_motion.h"
#include "cameras/fisheye_camera.h"
#include "cameras/orthographic_camera.h"
#include "cameras/panoramic_camera.h"
#include "cameras/perspective_camera.h"
#include "scene_spec/registry.h"

namespace candela {
namespace {

constexpr CameraEntry kCameras[] = {
    // name           create                       example
    {"perspective", &PerspectiveCamera::Create,
     "type perspective fov 40 aperture 0.2 focus_distance 5 blades 6 blade_rotation 15 "
     "tilt 0 50 shift 0.2 -0.4"},
    {"orthographic", &OrthographicCamera::Create,
     "type orthographic height 4 aperture 0.3 focus_distance 5"},
    {"fisheye", &FisheyeCamera::Create, "type fisheye mapping equisolid fov 220"},
    {"panoramic", &PanoramicCamera::Create, "type panoramic fov 180"},
};

Shutter ReadShutter(ParamReader* params) {
  if (!params->Has("shutter_interval")) return {};
  const Vec2 interval = params->Pair("shutter_interval", {0, 1});
  if (0 <= interval.x && interval.x <= interval.y && interval.y <= 1) {
    return {interval.x, interval.y};
  }
  params->Error(params->Where("shutter_interval"),
                fmt::format("'shutter_interval' expects two times from 0 to 1, the earlier one "
                            "first, found '{} {}'",
                            interval.x, interval.y));
  return {};
}

}  // namespace

std::span<const CameraEntry> CameraEntries() {
  return kCameras;
}

std::unique_ptr<Camera> CreateCamera(const TypedSpec& spec, Diagnostics* diagnostics,
                                     ParamSet* resolved) {
  const CameraEntry* entry = FindEntry<CameraEntry>(kCameras, spec, "camera", diagnostics);
  if (!entry) return nullptr;
  const size_t errors_before = diagnostics->ErrorCount();
  // Who names no kind knows a camera as the block alone.
  const std::string name = entry == kCameras ? "Camera" : fmt::format("{} camera", entry->name);
  ParamReader params(spec.params, name, spec.where, diagnostics, resolved);
  params.Has("type");  // The loader has taken it.
  CameraSpec view;
  ReadView(&params, &view);
  const std::optional<CameraMotion> motion = ReadMotion(&params, view);
  const Shutter shutter = ReadShutter(&params);
  auto camera = entry->create(&params, view);
  params.Finish();
  if (spec.params.is_damaged || diagnostics->ErrorCount() > errors_before) return nullptr;
  if (motion) camera = camera->Moving(*motion);
  camera->set_shutter(shutter);
  if (HasUp(view)) return camera;
  params.Error(params.Where("up"), "'up' is parallel to 'direction'");
  return nullptr;
}

}  // namespace candela
