#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cameras/image_plane.h"
#include "film/film.h"
#include "sampling/sampler.h"

namespace candela {

/// Where in a pixel the samples lie and how they are weighed.
enum class SamplePattern {
  kCentre,      ///< All at the pixel's position.
  kStrata,      ///< The course's `-jitter`: 4 x 4 strata, averaged.
  kStrataTent,  ///< The same samples, weighed with a tent of radius 1.
  kFilter,      ///< Any number, drawn from a pixel filter.
};

/// The samples of each pixel that the patterns of strata have.
constexpr uint32_t kStrataPerSide = 4;
constexpr uint32_t kStrataSamples = kStrataPerSide * kStrataPerSide;

/// What a picture is made of, apart from the scene and the integrator.
struct RenderOptions {
  int width = 800, height = 800;
  PixelWindow crop{0, 0, 800, 800};  ///< What is rendered of it; the pixels are those of the whole.
  PixelGrid grid = PixelGrid::kCorners;
  bool stretch = false;

  SamplePattern pattern = SamplePattern::kCentre;
  std::string filter = "box";  ///< For `kFilter`: a name of `PixelFilters()`.
  uint32_t samples = 1;        ///< Per pixel, at most; `kStrataSamples` for strata.
  uint32_t seed = 0;
  SamplerType sampler;

  /// The relative standard error above which a pixel is noisy. There are samples until in each
  /// block few pixels are (see `NoiseBlock`), or as many as there may be. For samplers whose pixels
  /// are independent, and not for strata.
  std::optional<float> noise_target;
  /// Seconds of rendering after which there are no more samples. Every pixel gets one. Not for
  /// strata.
  std::optional<double> time_limit;

  LayerSet layers;  ///< What is recorded beside the colours.
  /// The groups of lights of the scene, where their layers are recorded.
  std::vector<std::string> light_groups;
  std::optional<float> clamp;   ///< The most that a channel of a sample may have.
  bool drops_negative = false;  ///< Negative samples are mistakes, not the scene's will.
  uint32_t tile_size =
      32;  ///< Side of the blocks that threads take; changes nothing in the picture.
};

}  // namespace candela
