#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "base/result.h"
#include "driver/arg_parser.h"
#include "driver/render_request.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// What a lens does to the whole picture, whatever its format. Part of `PictureSettings`.
class LensSettings {
 public:
  /// bloom, vignette
  void Add(ArgParser* parser);

  /// Whether the camera of the scene has such a lens, as far as the scene asks for it.
  void CheckScene(const ArgParser& parser, const SceneSpec& spec, Diagnostics* diagnostics);
  /// The same for what the command line asks for.
  Result<void> Check(const ArgParser& parser) const;

  LensEffects Effects() const;

 private:
  std::optional<float> bloom_strength_, bloom_radius_, vignette_;
  bool has_flat_film_ = true;  ///< The camera of the scene, behind its lens.
};

}  // namespace candela
