#pragma once

#include <cstdint>
#include <string>

#include "integrators/integrator.h"

namespace candela {

/// Where the time of one render went, and what was done in it.
struct RenderStatistics {
  /// Wall time in seconds.
  struct Phases {
    double load = 0;    ///< Reading the scene and its meshes.
    double build = 0;   ///< Compiling it: textures and the search tree.
    double render = 0;  ///< Tracing rays.
    double encode =
        0;  ///< Turning pictures into files, as far as that was not done while rendering.
    double write = 0;  ///< Writing and syncing them.

    double Total() const { return load + build + render + encode + write; }
  };

  std::string scene;  ///< As the user named it.
  std::string integrator;
  int width = 0, height = 0;     ///< Of what was rendered: the crop window.
  double samples_per_pixel = 0;  ///< In the mean, of the picture.
  int threads = 0;
  std::string accelerator;  ///< What finds the hits,
  std::string isa;          ///< and the instruction set.
  Phases seconds;
  RayCounts rays;
  uint64_t dropped_samples = 0;  ///< NaN, infinite or negative ones.
  uint64_t scene_bytes = 0;      ///< Memory of the compiled scene.
  uint64_t peak_bytes = 0;       ///< Memory of the process; 0 where the system does not tell.

  double RaysPerSecond() const {
    return seconds.render > 0 ? static_cast<double>(rays.Total()) / seconds.render : 0;
  }
};

/// A table for people.
std::string StatisticsToText(const RenderStatistics& statistics);

/// The same as a JSON object that ends with a newline.
std::string StatisticsToJson(const RenderStatistics& statistics);

}  // namespace candela
