#include "driver/load_scene.h"

#include <fmt/format.h>

#include <cstdio>

#include "base/clock.h"
#include "base/diagnostics.h"
#include "loaders/course/scene_parser.h"

namespace candela {

Result<LoadedScene> LoadSceneForUser(const std::filesystem::path& path,
                                     const SettingsReader& read_settings, const SceneCheck& check) {
  LoadedScene loaded;
  Diagnostics diagnostics;
  const Stopwatch load_clock;
  loaded.spec = LoadScene(path, &diagnostics);
  const Result<CompileOptions> options = read_settings(loaded.spec, &diagnostics);
  loaded.load_seconds = load_clock.Seconds();
  if (!options && !diagnostics.HasErrors()) return options.error();
  // Also after errors, so that one run shows those of both.
  const Stopwatch build_clock;
  loaded.scene = CompileScene(loaded.spec, &diagnostics, options ? *options : CompileOptions());
  loaded.build_seconds = build_clock.Seconds();
  if (loaded.scene && check) check(*loaded.scene, &diagnostics);
  for (const std::string& line : diagnostics.Lines()) fmt::print(stderr, "{}\n", line);
  if (diagnostics.HasErrors()) return Error{diagnostics.Code(), {}};
  loaded.warnings = diagnostics.WarningCount();
  return loaded;
}

}  // namespace candela
