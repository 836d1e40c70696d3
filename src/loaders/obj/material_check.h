#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "loaders/obj/obj_parser.h"

namespace candela {

/// Warns of MTL files that cannot be read and of material names that no MTL file holds. Nothing
/// else is read from them, since materials come from the scene. Only relative paths that stay in
/// `folder` are followed, and no more than 64. Returns those that were read.
std::vector<std::filesystem::path> CheckMaterials(const ObjContent& content,
                                                  const std::shared_ptr<const std::string>& file,
                                                  const std::filesystem::path& folder,
                                                  Diagnostics* diagnostics);

}  // namespace candela
