#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace candela {

/// Where the set is stored.
std::filesystem::path MalformedSet();

/// The scenes of the set, as "topic/name".
std::vector<std::string> MalformedScenes();

/// The whole output that is expected of `candela check` for a scene, then "exit N".
std::string ExpectedOutput(const std::string& scene);

/// A copy of the set with its companions, where nothing disturbs and nothing is disturbed. Made
/// when first asked for and gone at the end of the program.
const std::filesystem::path& MalformedCopy();

}  // namespace candela
