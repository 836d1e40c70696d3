#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "base/diagnostics.h"
#include "cameras/camera.h"
#include "cameras/camera_spec.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// A kind of camera that scenes may name.
struct CameraEntry {
  std::string_view name;
  /// `view` is where the camera stands and looks, which all kinds have in common.
  std::unique_ptr<Camera> (*create)(ParamReader* params, CameraSpec view);
  /// What stands in a `Camera` block beside the view, for the contract tests and the manual.
  std::string_view example;
};

std::span<const CameraEntry> CameraEntries();

/// Creates the camera that `spec` describes; null when there is no such kind, or when it cannot be
/// made, which is reported. `resolved`, where it is not null, gets its parameters; see
/// `ParamReader`.
std::unique_ptr<Camera> CreateCamera(const TypedSpec& spec, Diagnostics* diagnostics,
                                     ParamSet* resolved = nullptr);

}  // namespace candela
