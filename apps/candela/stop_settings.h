#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/diagnostics.h"
#include "base/result.h"
#include "driver/arg_parser.h"
#include "driver/render_request.h"
#include "scene_spec/param_set.h"

namespace candela {

/// When a picture is good enough, other than by a number of samples. Part of `PictureSettings`.
class StopSettings {
 public:
  explicit StopSettings(RenderRequest* request) : request_(*request) {}

  /// noise-target, time-limit
  void Add(ArgParser* parser);

  /// Whoever asks for the course's samples gets all of them, whatever the scene says.
  void DropThoseOfScene(const ArgParser& parser);
  /// Whether what the scene asks for can be done; `settings` are those for its rendering.
  void CheckScene(const ArgParser& parser, const ParamSet& settings, std::string_view sampler,
                  Diagnostics* diagnostics);
  /// The same for the command line, together with everything else.
  Result<void> Check(const ArgParser& parser) const;

  /// The most samples that a pixel gets where nobody says it, if there is something else to stop
  /// for.
  std::optional<uint32_t> UsualSamples() const;

 private:
  RenderRequest& request_;
};

}  // namespace candela
