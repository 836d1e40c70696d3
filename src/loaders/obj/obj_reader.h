#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "scene_spec/mesh_spec.h"

namespace candela {

/// Reads the geometry of a Wavefront OBJ text: v, vn and f lines; the other known keywords have no
/// effect. Polygons become triangles. What is wrong goes to `diagnostics` under the name `file`;
/// the mesh is then incomplete and not to be used.
MeshSpec ParseObj(std::shared_ptr<const std::string> file, std::string_view text,
                  Diagnostics* diagnostics);

/// The same for the file `path`. `asked` is the place that asks for it: a missing or unreadable
/// file is reported there. Returns null when anything was wrong.
std::shared_ptr<const MeshSpec> LoadObj(const std::filesystem::path& path,
                                        const SourceLocation& asked, Diagnostics* diagnostics);

}  // namespace candela
