#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/isa.h"
#include "driver/lens_effects.h"
#include "driver/load_scene.h"
#include "image/tone_curve.h"
#include "integrators/registry.h"
#include "render/render_options.h"

namespace candela {

/// How picture files are written.
struct OutputOptions {
  int png_bits = 8;  ///< 8 or 16.
  ToneMapping tone;  ///< Of the colour picture,
  LensEffects lens;  ///< and what comes before it, in all formats.
  /// An EXR file of it tells how it was made. Not by the course program, whose files hold what the
  /// course says.
  bool has_facts = false;
};

/// A depth map and the range of distances that it shows from black to white.
struct DepthOutput {
  float min = 0, max = 1;
  std::filesystem::path path;
};

/// Everything that a command line asks of one render. Paths are as the user wrote them.
struct RenderRequest {
  std::string program;  ///< Its name, for messages.
  std::filesystem::path scene;
  std::optional<std::filesystem::path> output, normals;
  std::optional<DepthOutput> depth;

  std::string integrator = "whitted";
  IntegratorOptions integrator_options;
  RenderOptions render;
  OutputOptions output_options;
  int threads = 0;                  ///< 0: one per processor.
  std::string accelerator = "bvh";  ///< One of the table of accelerators.
  std::optional<Isa> isa;           ///< Nothing: the best that the processor knows.

  /// Where what was rendered is kept, to be continued, and every how many seconds of a long render.
  std::optional<std::filesystem::path> checkpoint;
  std::optional<double> checkpoint_seconds;

  bool quiet = false;
  bool print_stats = false;
  std::optional<std::filesystem::path> stats_json;
  /// Explain this pixel instead of rendering.
  struct PixelPosition {
    int x, y;
  };
  std::optional<PixelPosition> explain;

  /// The pictures that will be written.
  std::vector<std::filesystem::path> Pictures() const {
    std::vector<std::filesystem::path> paths;
    if (output) paths.push_back(*output);
    if (normals) paths.push_back(*normals);
    if (depth) paths.push_back(depth->path);
    return paths;
  }
};

/// Carries it out: checks the outputs, loads the scene, renders, writes. Prints messages to stderr,
/// what was asked for to stdout, and returns the exit status of the program. `read_settings` may
/// complete the request by what the scene says about rendering; until it is called only the scene,
/// the outputs and what concerns the machine have to be there.
int RunRender(const RenderRequest& request, const SettingsReader& read_settings);

}  // namespace candela
