// candela check: reads and compiles a scene, renders nothing.

#include <fmt/format.h>

#include "base/result.h"
#include "candela/commands.h"
#include "candela/render_settings.h"
#include "candela/scene_facts.h"
#include "driver/arg_parser.h"
#include "driver/console.h"
#include "driver/find_scene.h"
#include "driver/load_scene.h"
#include "integrators/registry.h"

namespace candela {
namespace {

constexpr const char* kSummary =
    "Reads a scene with everything that belongs to it and reports what is wrong, each with its "
    "place, on stderr. A good one is summed up in one line on stdout.";

std::string Summary(const std::filesystem::path& path, const LoadedScene& loaded) {
  const SceneFacts facts(loaded);
  std::string summary = fmt::format("{}: ok, {}, ", path.string(), Count(facts.objects, "object"));
  if (facts.triangles > 0) summary += Count(facts.triangles, "triangle") + ", ";
  summary +=
      fmt::format("{}, {}", Count(facts.lights, "light"), Count(facts.materials, "material"));
  if (loaded.warnings > 0) summary += ", " + Count(loaded.warnings, "warning");
  return summary + "\n";
}

}  // namespace

int RunCheckCommand(Words words) {
  std::filesystem::path name;
  ArgParser parser("candela check", kSummary, ArgStyle::kGnu);
  parser.Positional(File("SCENE", &name), "scene to read");
  parser.Example("my_scene.txt && echo good", "exit status 0 for a good scene, 1 for a bad one");
  if (const auto status = ReadCommandLine(parser, words)) return *status;

  const auto path = FindScene(name, SceneFolders());
  if (!path) return PrintError(parser.program(), path.error());
  RenderSettings settings;
  const auto read_settings = [&](const SceneSpec& spec, Diagnostics* diagnostics) {
    settings = ReadRenderSettings(spec, diagnostics);
    return Result<CompileOptions>(settings.compilation);
  };
  const auto check = [&](const Scene& scene, Diagnostics* diagnostics) {
    CheckForIntegrator(settings.integrator, scene, diagnostics);
  };
  const auto loaded = LoadSceneForUser(*path, read_settings, check);
  if (!loaded) return static_cast<int>(loaded.error().code);
  return PrintResult(parser.program(), Summary(*path, *loaded));
}

}  // namespace candela
