// Scene texts: whatever they hold, reading ends, and a scene without errors can be compiled.
#include <string_view>

#include "base/check.h"
#include "loaders/course/scene_parser.h"
#include "scene/compile_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  using namespace candela;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto file = std::make_shared<const std::string>("scene.txt");
  Diagnostics diagnostics;
  // Files that the text names are not found there, so every run reads the same.
  const SceneSpec spec = ParseScene(file, text, "/nowhere", &diagnostics);

  // Compiled also after errors: programs do so to find more of them.
  const bool has_scene = CompileScene(spec, &diagnostics) != nullptr;
  CHECK(has_scene != diagnostics.HasErrors());
  for (const std::string& line : diagnostics.Lines()) CHECK(line.size() < 500);
  return 0;
}
