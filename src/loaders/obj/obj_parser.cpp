#include "loaders/obj/obj_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "base/number.h"
#include "base/text.h"

namespace candela {
namespace {

constexpr uint32_t kNoNormal = MeshSpec::kNoNormal;
constexpr uint32_t kLongestList = std::numeric_limits<uint32_t>::max() - 1;
constexpr const char* kListNames[] = {"vertex", "texture", "normal"};
constexpr const char* kListPlurals[] = {"vertices", "texture vertices", "normals"};

}  // namespace

ObjParser::ObjParser(std::shared_ptr<const std::string> file, std::string_view text,
                     Diagnostics* diagnostics)
    : file_(std::move(file)), lines_(text), diagnostics_(*diagnostics) {}

ObjContent ObjParser::Parse() {
  for (Token keyword = lines_.NextLine(); keyword.IsWord() && !is_full_;
       keyword = lines_.NextLine()) {
    ParseLine(keyword);
  }
  is_at_end_ = true;
  for (size_t i = 0; i < early_faces_.size() && !is_full_; ++i) {
    LineTokenizer words = early_faces_[i].words;
    ParseFace(early_faces_[i], &words);
  }
  FinishNormals();
  if (content_.mesh.uv_corners.empty()) content_.mesh.uvs = {};
  WarnOfTallies();
  return std::move(content_);
}

void ObjParser::ParseLine(const Token& keyword) {
  switch (FindObjLine(keyword.text)) {
    case ObjLine::kPosition:
      return ParsePosition(keyword);
    case ObjLine::kNormal:
      return ParseNormal(keyword);
    case ObjLine::kTexture:
      return ParseTexture(keyword);
    case ObjLine::kFace:
      content_.has_faces = true;
      return ParseFace({keyword, counts_, lines_}, &lines_);
    case ObjLine::kMaterialFile:
      if (const Token name = lines_.NextName(); name.IsWord()) {
        content_.material_files.push_back(name);
      }
      return;
    case ObjLine::kMaterial:
      if (const Token name = lines_.NextName(); name.IsWord()) {
        content_.used_materials.emplace(name.text, name);
      }
      return;
    case ObjLine::kNoEffect:
      return;
    case ObjLine::kLeftOut:
    case ObjLine::kUnknown:
      return WarnOnce(keyword);
  }
}

void ObjParser::ParsePosition(const Token& keyword) {
  Vec3 position;
  const auto count = ParseNumbers(keyword, &position);
  // What may follow is a weight or a colour, which have no effect.
  if (count && *count < 3) {
    Error(keyword, fmt::format("'v' needs at least three coordinates, found {}", *count));
  }
  // A wrong line takes its place too, or all indices behind it would be wrong.
  content_.mesh.positions.push_back(position);
  Grow(kPositions, keyword);
}

void ObjParser::ParseNormal(const Token& keyword) {
  Vec3 normal;
  const auto count = ParseNumbers(keyword, &normal);
  if (count && *count != 3) {
    Error(keyword, fmt::format("'vn' needs three coordinates, found {}", *count));
  } else if (count && normal == Vec3{}) {
    zero_normals_.Add(keyword);
  }
  content_.mesh.normals.push_back(normal);
  Grow(kNormals, keyword);
}

void ObjParser::ParseTexture(const Token& keyword) {
  Vec3 uvw;
  const auto count = ParseNumbers(keyword, &uvw);
  if (count && (*count < 1 || *count > 3)) {
    Error(keyword, fmt::format("'vt' needs one to three coordinates, found {}", *count));
  }
  content_.mesh.uvs.push_back({uvw.x, uvw.y});
  Grow(kTextures, keyword);
}

/// Reads numbers up to the end of the line and returns how many there are; nothing when a word is
/// none, which is reported.
std::optional<size_t> ObjParser::ParseNumbers(const Token& keyword, Vec3* first_three) {
  size_t count = 0;
  for (Token word = lines_.NextWord(); word.IsWord(); word = lines_.NextWord()) {
    const auto number = ParseFloat(word.text);
    if (!number) {
      Error(word, fmt::format("'{}' expects numbers, found {}", keyword.text, Quote(word.text)));
      return std::nullopt;
    }
    if (count < 3) (*first_three)[static_cast<int>(count)] = *number;
    ++count;
  }
  return count;
}

void ObjParser::Grow(List list, const Token& keyword) {
  if (++counts_[list] < kLongestList) return;
  Error(keyword, fmt::format("more than {} {}", kLongestList - 1, kListPlurals[list]));
  is_full_ = true;
}

void ObjParser::ParseFace(const FaceLine& face, LineTokenizer* words) {
  corners_.clear();
  is_early_ = false;
  bool is_sound = true;
  for (Token word = words->NextWord(); word.IsWord(); word = words->NextWord()) {
    const auto corner = ParseCorner(word, face.above);
    if (is_full_) return;
    is_sound = is_sound && corner;
    corners_.push_back(corner.value_or(Corner{}));
  }
  if (!is_sound) return;
  if (corners_.size() < 3) {
    Error(face.keyword, fmt::format("'f' needs at least three corners, found {}", corners_.size()));
  } else if (corners_.size() > kLongestList) {
    Error(face.keyword, fmt::format("more than {} corners", kLongestList));
  } else if (is_early_) {
    early_faces_.push_back(face);
  } else {
    AddFace(face.keyword);
  }
}

std::optional<ObjParser::Corner> ObjParser::ParseCorner(const Token& word, const Counts& above) {
  const auto indices = ParseObjCorner(word.text);
  if (!indices) {
    Error(word, fmt::format("'f' expects corners like v, v/vt, v//vn or v/vt/vn, found {}",
                            Quote(word.text)));
    return std::nullopt;
  }
  Corner corner;
  const auto position = Resolve(word, kPositions, indices->position, above);
  if (!position) return std::nullopt;
  corner.position = *position;
  if (indices->texture) {
    const auto uv = Resolve(word, kTextures, *indices->texture, above);
    if (!uv) return std::nullopt;
    corner.uv = *uv;
  }
  if (indices->normal) {
    const auto normal = Resolve(word, kNormals, *indices->normal, above);
    if (!normal) return std::nullopt;
    corner.normal = *normal;
  }
  return corner;
}

/// The place in the list that an index means; nothing when there is none, which is reported. What
/// may still come sets `is_early_`.
std::optional<uint32_t> ObjParser::Resolve(const Token& word, List list, int64_t index,
                                           const Counts& above) {
  if (index > 0 && index <= counts_[list]) return static_cast<uint32_t>(index - 1);
  if (index < 0 && index >= -int64_t{above[list]}) {
    return static_cast<uint32_t>(above[list] + index);
  }
  if (index > 0 && !is_at_end_) {
    is_early_ = true;
    return 0;
  }
  if (index == 0) {
    Error(word, fmt::format("{} index 0 in {}: indices count from 1", kListNames[list],
                            Quote(word.text)));
    return std::nullopt;
  }
  const uint32_t count = index < 0 ? above[list] : counts_[list];
  Error(word, fmt::format("{} index {} in {} is out of range: there {} {} {}{}", kListNames[list],
                          index, Quote(word.text), count == 1 ? "is" : "are", count,
                          count == 1 ? kListNames[list] : kListPlurals[list],
                          index < 0 ? " before it" : ""));
  return std::nullopt;
}

void ObjParser::AddFace(const Token& keyword) {
  bool has_area = false;
  if (corners_.size() == 3) {
    has_area = AddTriangle(corners_[0], corners_[1], corners_[2]);
  } else {
    polygon_.clear();
    for (const Corner& corner : corners_) {
      polygon_.push_back(content_.mesh.positions[corner.position]);
    }
    for (const auto& [a, b, c] : cutter_.Cut(polygon_)) {
      has_area |= AddTriangle(corners_[a], corners_[b], corners_[c]);
    }
  }
  if (!has_area) flat_faces_.Add(keyword);
  if (content_.mesh.triangles.size() > kLongestList) {
    Error(keyword, fmt::format("more than {} triangles", kLongestList));
    is_full_ = true;
  }
}

/// Leaves triangles without area out and says so.
bool ObjParser::AddTriangle(const Corner& a, const Corner& b, const Corner& c) {
  MeshSpec& mesh = content_.mesh;
  const Vec3d p = ToDouble(mesh.positions[a.position]);
  if (Cross(ToDouble(mesh.positions[b.position]) - p, ToDouble(mesh.positions[c.position]) - p) ==
      Vec3d{}) {
    return false;
  }
  mesh.triangles.push_back({a.position, b.position, c.position});
  AddCorners({a.normal, b.normal, c.normal}, kNoNormal, &mesh.normal_corners);
  AddCorners({a.uv, b.uv, c.uv}, MeshSpec::kNoUv, &mesh.uv_corners);
  return true;
}

void ObjParser::AddCorners(const MeshSpec::Corners& corners, uint32_t none,
                           std::vector<MeshSpec::Corners>* list) {
  if (list->empty()) {
    if (corners[0] == none && corners[1] == none && corners[2] == none) return;
    list->assign(content_.mesh.triangles.size() - 1, {none, none, none});
  }
  list->push_back(corners);
}

/// Settles what only the whole file tells: the normals of corners that name none, and which of the
/// named ones are zero.
void ObjParser::FinishNormals() {
  MeshSpec& mesh = content_.mesh;
  const bool by_position = !mesh.normals.empty() && mesh.normals.size() == mesh.positions.size();
  if (by_position && mesh.normal_corners.empty()) mesh.normal_corners = mesh.triangles;
  bool is_any_left = false;
  for (size_t i = 0; i < mesh.normal_corners.size(); ++i) {
    for (size_t k = 0; k < 3; ++k) {
      uint32_t& normal = mesh.normal_corners[i][k];
      if (normal == kNoNormal && by_position) normal = mesh.triangles[i][k];
      if (normal != kNoNormal && mesh.normals[normal] == Vec3{}) normal = kNoNormal;
      is_any_left |= normal != kNoNormal;
    }
  }
  if (is_any_left) return;
  mesh.normals.clear();
  mesh.normal_corners.clear();
}

void ObjParser::Error(const Token& token, std::string text) {
  diagnostics_.Error(Where(token), std::move(text));
  is_full_ = is_full_ || diagnostics_.IsFull(Where(token));
}

void ObjParser::WarnOnce(const Token& keyword) {
  if (!warned_of_.insert(keyword.text).second) return;
  // No more than so many are shown: a file of a million unknown words need not search near ones.
  const bool is_shown = warned_of_.size() <= Diagnostics::kMostPerFile;
  diagnostics_.Warning(Where(keyword), is_shown ? ObjLineWarning(keyword.text) : std::string());
}

void ObjParser::WarnOfTallies() {
  if (flat_faces_.count == 1) {
    diagnostics_.Warning(Where(flat_faces_.first), "a face without area is left out");
  } else if (flat_faces_.count > 1) {
    diagnostics_.Warning(
        Where(flat_faces_.first),
        fmt::format("{} faces without area are left out, this one first", flat_faces_.count));
  }
  if (zero_normals_.count == 1) {
    diagnostics_.Warning(Where(zero_normals_.first),
                         "a zero normal: the geometric normal is used instead");
  } else if (zero_normals_.count > 1) {
    diagnostics_.Warning(Where(zero_normals_.first),
                         fmt::format("{} zero normals, this one first: the geometric normal is "
                                     "used instead",
                                     zero_normals_.count));
  }
}

}  // namespace candela
