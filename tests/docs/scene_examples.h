#pragma once

#include <string>
#include <vector>

namespace candela::docs {

/// The files that the examples name lie there.
inline constexpr const char* kExampleFolder = "assets/assignment4";

/// A scene that the manual of the scene format shows, made whole where it is a part of one.
struct SceneExample {
  std::string text;
  int line;       ///< In the manual.
  bool is_wrong;  ///< What follows it in the manual is what is said about it.
  std::string messages;
};

/// All but the one that includes files, which are shown as well.
std::vector<SceneExample> SceneExamples();

}  // namespace candela::docs
