#pragma once

#include <cstdlib>
#include <filesystem>

namespace candela::testing_support {

/// Where the course's own scenes (assets/) and pictures (reference/) lie, which are no part of the
/// project: the folder that the variable CANDELA_COURSE names, else one beside the checkout. Tests
/// run in the root of the project.
inline std::filesystem::path CourseFolder() {
  const char* folder = std::getenv("CANDELA_COURSE");
  return folder ? folder : "../shared/course";
}

}  // namespace candela::testing_support
