#include "tests/malformed/malformed_set.h"

#include <algorithm>

#include "tests/malformed/companions.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace fs = std::filesystem;

fs::path MalformedSet() {
  return fs::absolute("tests/malformed/set");
}

std::vector<std::string> MalformedScenes() {
  std::vector<std::string> scenes;
  for (const auto& entry : fs::recursive_directory_iterator(MalformedSet())) {
    if (entry.path().extension() != ".txt") continue;
    scenes.push_back(fs::relative(entry.path(), MalformedSet()).replace_extension().string());
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

std::string ExpectedOutput(const std::string& scene) {
  return testing_support::Get(MalformedSet() / (scene + ".expected"));
}

const fs::path& MalformedCopy() {
  static const testing_support::TempFolder folder;
  static const bool is_made = [] {
    fs::copy(MalformedSet(), folder.path(), fs::copy_options::recursive);
    MakeCompanions(folder.path());
    return true;
  }();
  static_cast<void>(is_made);
  return folder.path();
}

}  // namespace candela
