#include "loaders/obj/obj_reader.h"

#include <fmt/format.h>

#include <utility>

#include "base/files.h"
#include "base/text.h"
#include "loaders/obj/material_check.h"
#include "loaders/obj/obj_parser.h"
#include "loaders/text/nul_check.h"

namespace candela {

MeshSpec ParseObj(std::shared_ptr<const std::string> file, std::string_view text,
                  Diagnostics* diagnostics) {
  if (HasNul(file, text, diagnostics)) return {};
  return ObjParser(std::move(file), text, diagnostics).Parse().mesh;
}

std::shared_ptr<const MeshSpec> LoadObj(const std::filesystem::path& path,
                                        const SourceLocation& asked, Diagnostics* diagnostics,
                                        std::vector<std::filesystem::path>* mtl_files) {
  const Result<std::string> text = ReadFile(path);
  if (!text) {
    diagnostics->Error(asked,
                       fmt::format("mesh {}: {}", Quote(path.string()), text.error().message),
                       text.error().code);
    return nullptr;
  }
  const auto file = std::make_shared<const std::string>(path.string());
  const size_t errors_before = diagnostics->ErrorCount();
  if (HasNul(file, *text, diagnostics)) return nullptr;

  ObjContent content = ObjParser(file, *text, diagnostics).Parse();
  if (!content.has_faces) diagnostics->Error({file, 0, 0}, "the mesh has no faces");
  const auto read = CheckMaterials(content, file, path.parent_path(), diagnostics);
  if (mtl_files) mtl_files->insert(mtl_files->end(), read.begin(), read.end());
  if (diagnostics->ErrorCount() > errors_before) return nullptr;
  return std::make_shared<const MeshSpec>(std::move(content.mesh));
}

}  // namespace candela
