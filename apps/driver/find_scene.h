#pragma once

#include <filesystem>
#include <vector>

#include "base/result.h"

namespace candela {

/// Where scenes that ship with Candela are looked for, in this order: `assets/assignment4` of the
/// working directory, of the folder of the program, and of an installation around that folder.
std::vector<std::filesystem::path> SceneFolders();

/// The scene that the user means by `name`: the path as given if there is anything, else the first
/// file of that name below `folders`. The error tells where it was looked for and the nearest name
/// that exists.
Result<std::filesystem::path> FindScene(const std::filesystem::path& name,
                                        const std::vector<std::filesystem::path>& folders);

}  // namespace candela
