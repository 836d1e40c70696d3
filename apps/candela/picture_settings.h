#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "base/result.h"
#include "candela/exposure_settings.h"
#include "candela/lens_settings.h"
#include "candela/stop_settings.h"
#include "driver/arg_parser.h"
#include "driver/common_options.h"
#include "driver/render_request.h"
#include "scene_spec/param_set.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// The options of `candela render` that say how the picture comes about, many of which scenes may
/// set as well, and what follows from them together. Lives as long as the parser that it adds
/// options to.
class PictureSettings {
 public:
  explicit PictureSettings(RenderRequest* request) : request_(*request), stop_(request) {}

  /// tonemap, and those of `ExposureSettings` and `LensSettings`
  void AddTone(ArgParser* parser);
  /// pixel-grid
  void AddGrid(ArgParser* parser);
  /// integrator, those of `common`, limits of bounces by their kind, those of
  /// distribution ray tracing, ao-distance, view
  void AddLight(ArgParser* parser, CommonOptions* common);
  /// samples, those of `StopSettings`, filter, sampler, clamp, jitter, seed
  void AddSamples(ArgParser* parser);

  // What can be said without the scene.
  Result<void> CheckJitter() const;
  Result<void> CheckTone(const ArgParser& parser) const;
  /// What can be said of the exposure and the lens once the settings of the scene are known.
  Result<void> CheckFilm(const ArgParser& parser) const;

  /// What can be said of the end of the work once everything is known.
  Result<void> CheckStop(const ArgParser& parser) const { return stop_.Check(parser); }

  /// What the scene and the command line say of the same in different words.
  void MergeFilm(const ArgParser& parser, const SceneSpec& spec, Diagnostics* diagnostics);
  /// Whoever asks for the course's samples does not get those of the scene.
  void DropSamplesOfScene(const ArgParser& parser);
  /// What the integrator does not know of what the scene or the command line sets is dropped with a
  /// warning, or is an error when it would not do what was asked for. `settings` are the scene's
  /// for its rendering.
  void CheckForIntegrator(const ArgParser& parser, const ParamSet& settings,
                          Diagnostics* diagnostics);
  /// Completes the request once the settings of the scene are known, and stores what follows from
  /// others in the options that scenes may set.
  void Finish();

 private:
  /// light-samples, glossy-samples, indirect-samples, indirect-sampling, depth-of-field
  void AddDistribution(ArgParser* parser);
  void CheckClamp(const ArgParser& parser, const ParamSet& settings, Diagnostics* diagnostics);
  void FinishSamples();
  void FinishSampler();
  void FinishGrid();
  void FinishView();
  void FinishTone();
  /// Whether pixels are means of many samples, for which there are defaults of their own.
  bool IsSampled() const;

  RenderRequest& request_;
  bool jitter_ = false;
  std::string sampler_ = "sobol";
  std::optional<std::string> filter_, grid_, tonemap_, view_, indirect_sampling_, light_choice_;
  ExposureSettings exposure_;
  LensSettings lens_;
  StopSettings stop_;
  std::optional<uint32_t> samples_;
};

}  // namespace candela
