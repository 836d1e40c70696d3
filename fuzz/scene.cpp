// Scene texts: whatever they hold, reading ends, a scene without errors can be compiled, and what
// it resolves to is a scene as well, which resolves to itself.
#include <memory>
#include <string>
#include <string_view>

#include "base/check.h"
#include "loaders/course/scene_parser.h"
#include "loaders/course/scene_writer.h"
#include "scene/compile_scene.h"

namespace candela {
namespace {

void CheckResolved(const SceneSpec& resolved) {
  const std::string text = WriteScene(resolved);
  Diagnostics diagnostics;
  SceneSpec again;
  CompileScene(ParseScene(nullptr, text, "/nowhere", &diagnostics), &diagnostics,
               {AcceleratorKind::kBvh, &again});
  CHECK(!diagnostics.HasErrors());
  CHECK(WriteScene(again) == text);
}

}  // namespace
}  // namespace candela

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  using namespace candela;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto file = std::make_shared<const std::string>("scene.txt");
  Diagnostics diagnostics;
  // Files that the text names are not found there, so every run reads the same.
  const SceneSpec spec = ParseScene(file, text, "/nowhere", &diagnostics);

  // Compiled also after errors: programs do so to find more of them.
  SceneSpec resolved;
  const bool has_scene =
      CompileScene(spec, &diagnostics, {AcceleratorKind::kBvh, &resolved}) != nullptr;
  CHECK(has_scene != diagnostics.HasErrors());
  for (const std::string& line : diagnostics.Lines()) CHECK(line.size() < 500);
  if (has_scene) CheckResolved(resolved);
  return 0;
}
