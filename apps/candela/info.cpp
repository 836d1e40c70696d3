// candela info: what a scene holds.

#include <fmt/format.h>

#include "base/result.h"
#include "candela/commands.h"
#include "candela/render_settings.h"
#include "candela/scene_facts.h"
#include "driver/arg_parser.h"
#include "driver/console.h"
#include "driver/find_scene.h"
#include "driver/load_scene.h"
#include "loaders/course/scene_writer.h"

namespace candela {
namespace {

constexpr const char* kSummary =
    "Shows what a scene holds: objects, triangles, lights, materials, meshes, the memory that it "
    "takes when it is rendered, its bounds and its camera.";

std::string Row(std::string_view name, std::string_view value) {
  return fmt::format("{:<12}{}\n", name, value);
}

std::string ToText(Vec3 v) {
  return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z);
}

/// "7 (4 mesh, 3 sphere)".
std::string WithTypes(uint64_t count, const std::map<std::string, uint64_t>& by_type) {
  std::string text = fmt::format("{}", count);
  std::string_view separator = " (";
  for (const auto& [type, number] : by_type) {
    text += fmt::format("{}{} {}", separator, number, type);
    separator = ", ";
  }
  return by_type.empty() ? text : text + ")";
}

std::string BoundsRow(const Bounds3& bounds) {
  if (bounds.IsEmpty()) return Row("bounds", "none: every object is unbounded");
  return Row("bounds", fmt::format("{} to {}", ToText(bounds.min), ToText(bounds.max)));
}

/// "0.1 MiB, 3 nodes deep, avx512".
std::string TreeRow(const SceneTree& tree) {
  const auto depth = static_cast<uint64_t>(tree.group->Depth());
  const double mebibytes = static_cast<double>(tree.MemoryBytes()) / (1 << 20);
  const AcceleratorKind kind = tree.group->accelerator();
  if (kind != AcceleratorKind::kBvh) {
    return Row("accelerator", fmt::format("{}, {:.1f} MiB", AcceleratorName(kind), mebibytes));
  }
  return Row("tree", fmt::format("{:.1f} MiB, {} deep, {}", mebibytes, Count(depth, "node"),
                                 IsaName(tree.group->isa())));
}

/// "integrator path, bounces 8".
std::string ToText(const ParamSet& settings) {
  std::string text;
  for (const Param& param : settings.params) {
    text += (text.empty() ? "" : ", ") + param.name;
    for (const ParamWord& word : param.words) text += " " + word.text;
  }
  return text;
}

std::string BackgroundText(const BackgroundSpec& background) {
  if (const auto& sky = background.sky) {
    return fmt::format("sky of turbidity {:.6g}, sun{} at an elevation of {:.6g} degrees",
                       sky->turbidity, sky->has_sun ? "" : " (off)", sky->sun_elevation_degrees);
  }
  if (!background.environment.empty()) return "environment " + background.environment;
  if (!background.cube_map.empty()) return "cube map " + background.cube_map;
  return ToText(background.color);
}

std::string Facts(const std::filesystem::path& path, const LoadedScene& loaded,
                  const RenderSettings& settings) {
  const SceneFacts facts(loaded);
  const BackgroundSpec& background = loaded.spec.background;
  std::string text = Row("scene", path.string());
  text += Row("objects", WithTypes(facts.objects, facts.objects_by_type));
  text += Row("triangles", fmt::format("{}", facts.triangles));
  for (const auto& [name, mesh] : loaded.spec.meshes) {
    text += Row("mesh", fmt::format("{}: {}, {}", name, Count(mesh->triangles.size(), "triangle"),
                                    Count(mesh->positions.size(), "position")));
  }
  text += Row("lights", WithTypes(facts.lights, facts.lights_by_type));
  text += Row("materials", fmt::format("{}", facts.materials));
  text += Row("background", BackgroundText(background));
  text += Row("ambient", ToText(background.ambient_light));
  text += BoundsRow(loaded.scene->Bounds());
  text += Row("camera", loaded.scene->camera().Description());
  text += Row("render", ToText(settings.render));
  text += Row("film", ToText(settings.film));
  text += TreeRow(loaded.scene->tree());
  text += Row("memory", fmt::format("{:.1f} MiB, textures and background included",
                                    static_cast<double>(loaded.scene->MemoryBytes()) / (1 << 20)));
  return text;
}

}  // namespace

int RunInfoCommand(Words words) {
  std::filesystem::path name;
  bool shows_resolved = false;
  ArgParser parser("candela info", kSummary, ArgStyle::kGnu);
  parser.Positional(File("SCENE", &name), "scene to read");
  parser.Group("What is shown");
  parser.Flag("resolved", &shows_resolved,
              "in place of a summary the scene itself, as a scene in which nothing is included and "
              "nothing left to defaults; it gives the same picture, from the same folder");
  parser.Example("scene06_bunny_1k.txt", "a scene that ships with Candela");
  parser.Example("my_scene.txt --resolved > my_scene_resolved.txt", "every default, written out");
  if (const auto status = ReadCommandLine(parser, words)) return *status;

  const auto path = FindScene(name, SceneFolders());
  if (!path) return PrintError(parser.program(), path.error());
  RenderSettings settings;
  SceneSpec resolved;
  const auto read_settings = [&](const SceneSpec& spec, Diagnostics* diagnostics) {
    settings = ReadRenderSettings(spec, diagnostics);
    if (shows_resolved) settings.compilation.resolved = &resolved;
    return Result<CompileOptions>(settings.compilation);
  };
  const auto loaded = LoadSceneForUser(*path, read_settings, {});
  if (!loaded) return static_cast<int>(loaded.error().code);
  if (shows_resolved) {
    resolved.render.params = settings.render;
    resolved.film.params = settings.film;
    return PrintResult(parser.program(), WriteScene(resolved));
  }
  return PrintResult(parser.program(), Facts(*path, *loaded, settings));
}

}  // namespace candela
