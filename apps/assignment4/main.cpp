// The course's program: its flags as they are, on the same library as `candela`.

#include <fmt/format.h>

#include <span>
#include <utility>

#include "base/signals.h"
#include "driver/arg_parser.h"
#include "driver/common_options.h"
#include "driver/console.h"
#include "driver/render_request.h"

namespace candela {
namespace {

constexpr const char* kSummary =
    "Renders a scene with recursive ray tracing. The scene is looked for as given, then in "
    "assets/assignment4 of the working directory, of the folder of the program, and of the "
    "installation.";

/// The samples that -jitter and -filter ask for; one without them gives what the reference gives.
void ChooseSamples(bool jitter, bool filter, RenderOptions* options) {
  if (!jitter && !filter) return;
  options->pattern = filter ? SamplePattern::kStrataTent : SamplePattern::kStrata;
  options->samples = kStrataSamples;
}

/// The course's program does what its command line says, whatever else a scene wishes.
Result<CompileOptions> WarnOfSettings(const SceneSpec& spec, Diagnostics* diagnostics) {
  for (const auto& [name, block] : {std::pair("Render", &spec.render), {"Film", &spec.film}}) {
    if (!block->is_given) continue;
    diagnostics->Warning(block->where, fmt::format("'{}' is for 'candela render'; this program "
                                                   "does what its command line says",
                                                   name));
  }
  return CompileOptions();
}

int Run(std::span<const char* const> words) {
  RenderRequest request;
  request.program = "assignment4";
  request.render.width = request.render.height = 200;
  bool jitter = false, filter = false;

  ArgParser parser(request.program, kSummary, ArgStyle::kCourse);
  CommonOptions common(&request);
  parser.Group("Scene and pictures");
  parser.Option("input", {File("FILE", &request.scene)}, "scene to read", {.required = true});
  common.AddPictures(&parser);
  common.AddFrame(&parser);
  parser.Group("Light");
  common.AddLight(&parser, "0");
  parser.Group("Samples");
  parser.Flag("jitter", &jitter, "average 4x4 samples of each pixel");
  parser.Flag("filter", &filter, "weigh these samples with a tent of radius 1; implies -jitter");
  parser.Example("-input scene01_plane.txt -output 01.png", "a picture of 200 x 200 pixels");
  parser.Example("-input scene06_bunny_1k.txt -output 06.png -size 800 800 -bounces 4",
                 "mirrors that show each other");
  parser.Example("-input scene07_arch.txt -output 07.png -shadows -bounces 4 -jitter -filter",
                 "shadows, and smooth edges");
  parser.Example("-input scene04_axes.txt -normals n.png -depth 8 18 d.png",
                 "what the camera rays hit, as normals and distances");

  if (const auto status = ReadCommandLine(parser, words)) return *status;
  ChooseSamples(jitter, filter, &request.render);
  Result<void> done = common.Finish(parser);
  if (done) done = common.FinishFiles(parser);
  if (!done) return PrintError(request.program, done.error());
  return RunRender(request, WarnOfSettings);
}

}  // namespace
}  // namespace candela

int main(int argc, char** argv) {
  candela::ExitOnStopSignals();
  return candela::RunWithinMemory("assignment4",
                                  [&] { return candela::Run(candela::WordsOf(argc, argv)); });
}
