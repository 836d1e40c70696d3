#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace candela::invariance {

/// What a scene is made of: a row of the table of the test. What goes with the size of the scene is
/// written in braces: {tenth} and {near} are lengths of 0.1 and 4.5 units, {per_length} is 1 per
/// unit.
struct SceneRow {
  const char* name;
  const char* ball;       ///< The material of a ball,
  const char* blobs;      ///< and of two blobs, which are meshes.
  const char* lights;     ///< Which of those of `LightNodes`, by their names.
  const char* sky = "";   ///< "even" or "picture".
  const char* lens = "";  ///< Parameters of the camera.
};

/// The scenes that have to look the same under every change.
std::vector<SceneRow> Scenes();

/// What is done to a scene that must not change its picture.
enum class Change {
  kNone,
  kRotate,
  kMove,
  kScale,    ///< Everything, with point lights as much brighter as distances grow.
  kMirror,   ///< The picture has to be mirrored as well.
  kCopy,     ///< Two copies of a mesh in place of two instances.
  kReorder,  ///< Objects in another order; lights stay in theirs.
  kSplit,    ///< Each triangle becomes four.
};

struct NamedChange {
  const char* name;
  Change change;
};
inline constexpr NamedChange kChanges[] = {
    {"rotated", Change::kRotate},  {"moved", Change::kMove},  {"scaled", Change::kScale},
    {"mirrored", Change::kMirror}, {"copied", Change::kCopy}, {"reordered", Change::kReorder},
    {"split", Change::kSplit},
};

/// The text of a scene, changed. Its files have to be in the scene's folder; see `PutFiles`.
std::string ChangedScene(const SceneRow& row, Change change);

/// Puts what the scenes need into a folder: meshes, and pictures of the sky.
void PutFiles(const std::filesystem::path& folder);

}  // namespace candela::invariance
