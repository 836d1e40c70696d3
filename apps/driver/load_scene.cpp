#include "driver/load_scene.h"

#include <fmt/format.h>

#include <cstdio>

#include "base/clock.h"
#include "base/diagnostics.h"
#include "loaders/course/scene_parser.h"
#include "scene/compile_scene.h"

namespace candela {

Result<LoadedScene> LoadSceneForUser(const std::filesystem::path& path) {
  LoadedScene loaded;
  Diagnostics diagnostics;
  const Stopwatch load_clock;
  loaded.spec = LoadScene(path, &diagnostics);
  loaded.load_seconds = load_clock.Seconds();
  // Also after errors, so that one run shows those of both.
  const Stopwatch build_clock;
  loaded.scene = CompileScene(loaded.spec, &diagnostics);
  loaded.build_seconds = build_clock.Seconds();
  for (const std::string& line : diagnostics.Lines()) fmt::print(stderr, "{}\n", line);
  if (!loaded.scene) return Error{diagnostics.Code(), {}};
  loaded.warnings = diagnostics.WarningCount();
  return loaded;
}

}  // namespace candela
