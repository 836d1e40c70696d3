#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "scene_spec/mesh_spec.h"

namespace candela {

/// Reads the geometry of a Wavefront OBJ text: v, vn and f lines; the other known keywords have no
/// effect. What is wrong goes to `diagnostics` under the name `file`; the mesh is then incomplete
/// and not to be used.
///
/// - Polygons become triangles (see `PolygonCutter`). Faces whose area is exactly zero are left out
///   with one warning for all of them.
/// - An explicit normal index counts ("v//vn"). Corners without one take the normal of the same
///   number as their position when the file has as many vn lines as v lines, else none. A zero
///   normal is no normal; one warning for all of them.
/// - A face may name vertices that come only later in the file; such faces are added last.
///   Negative indices count back from the face's own line.
MeshSpec ParseObj(std::shared_ptr<const std::string> file, std::string_view text,
                  Diagnostics* diagnostics);

/// The same for the file `path`; a file without any face is wrong. `asked` is the place that asks
/// for it: a missing or unreadable file is reported there. Returns null when anything was wrong.
/// The mesh may be empty: when all faces are left out.
///
/// MTL files in the OBJ's folder or below it are read too, only to warn of missing files and names;
/// materials come from the scene. Those that were read are added to `mtl_files`, if it is not null.
std::shared_ptr<const MeshSpec> LoadObj(const std::filesystem::path& path,
                                        const SourceLocation& asked, Diagnostics* diagnostics,
                                        std::vector<std::filesystem::path>* mtl_files = nullptr);

}  // namespace candela
