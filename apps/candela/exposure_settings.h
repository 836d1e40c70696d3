#pragma once

#include <optional>

#include "base/diagnostics.h"
#include "base/result.h"
#include "driver/arg_parser.h"
#include "scene_spec/param_set.h"

namespace candela {

/// How bright .png and .jpg files show the light: by stops, or as a camera has it. Part of
/// `PictureSettings`.
class ExposureSettings {
 public:
  /// exposure; iso, f-stop and shutter
  void Add(ArgParser* parser);

  /// What the command line says of one kind takes the place of what a scene, whose block `Film`
  /// this is, says of the other.
  void Merge(const ArgParser& parser, const ParamSet& film, Diagnostics* diagnostics);
  /// Whether what the command line asks for is complete, with the help of the scene.
  Result<void> Check(const ArgParser& parser) const;

  /// Whether it is by a camera's numbers.
  bool IsPhotographic() const { return f_stop_ && shutter_; }
  float Stops() const { return exposure_.value_or(0); }
  /// What light is multiplied with.
  float Gain() const;

  /// Shows the stops where scenes are shown with all their settings, or not.
  void Show(bool shows_stops);

 private:
  bool HasPhotographic() const { return iso_ || f_stop_ || shutter_; }

  std::optional<float> exposure_, iso_, f_stop_, shutter_;
};

}  // namespace candela
