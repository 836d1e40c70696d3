#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "loaders/obj/obj_corner.h"
#include "loaders/obj/obj_keywords.h"
#include "loaders/obj/polygon_cutter.h"
#include "loaders/text/line_tokenizer.h"
#include "scene_spec/mesh_spec.h"

namespace candela {

/// What an OBJ text holds. The tokens point into the text.
struct ObjContent {
  MeshSpec mesh;
  bool has_faces = false;                            ///< There are f lines, right or wrong.
  std::vector<Token> material_files;                 ///< The names of mtllib lines.
  std::map<std::string_view, Token> used_materials;  ///< Where each usemtl name stands first.
};

/// Reads one OBJ text, which must hold no NUL byte; see `ParseObj` for the rules. Stops early once
/// the file has shown its share of errors.
class ObjParser {
 public:
  ObjParser(std::shared_ptr<const std::string> file, std::string_view text,
            Diagnostics* diagnostics);

  /// To be called once.
  ObjContent Parse();

 private:
  enum List { kPositions, kTextures, kNormals };
  using Counts = std::array<uint32_t, 3>;

  /// A face line and how long the lists were above it.
  struct FaceLine {
    Token keyword;
    Counts above;
    LineTokenizer words;  ///< Stands behind the keyword.
  };
  struct Corner {
    uint32_t position = 0;
    uint32_t normal = MeshSpec::kNoNormal;
    uint32_t uv = MeshSpec::kNoUv;
  };
  /// Equal mistakes that are told once, with their number.
  struct Tally {
    uint64_t count = 0;
    Token first;
    void Add(const Token& where) {
      if (count++ == 0) first = where;
    }
  };

  void ParseLine(const Token& keyword);
  void ParsePosition(const Token& keyword);
  void ParseNormal(const Token& keyword);
  void ParseTexture(const Token& keyword);
  std::optional<size_t> ParseNumbers(const Token& keyword, Vec3* first_three);
  void Grow(List list, const Token& keyword);

  void ParseFace(const FaceLine& face, LineTokenizer* words);
  std::optional<Corner> ParseCorner(const Token& word, const Counts& above);
  std::optional<uint32_t> Resolve(const Token& word, List list, int64_t index, const Counts& above);
  void AddFace(const Token& keyword);
  bool AddTriangle(const Corner& a, const Corner& b, const Corner& c);
  /// Adds the indices of a triangle that was just added to a list which stays empty until a corner
  /// has one.
  void AddCorners(const MeshSpec::Corners& corners, uint32_t none,
                  std::vector<MeshSpec::Corners>* list);
  void FinishNormals();

  SourceLocation Where(const Token& token) const { return {file_, token.line, token.column}; }
  void Error(const Token& token, std::string text);
  void WarnOnce(const Token& keyword);
  void WarnOfTallies();

  std::shared_ptr<const std::string> file_;
  LineTokenizer lines_;
  Diagnostics& diagnostics_;
  bool is_full_ = false;

  ObjContent content_;
  Counts counts_ = {};                 ///< Lines of each list so far, wrong ones included.
  bool is_at_end_ = false;             ///< The lists are complete.
  bool is_early_ = false;              ///< The face at hand names something that is not there yet.
  std::vector<FaceLine> early_faces_;  ///< Such faces, to be read again at the end.
  std::set<std::string_view> warned_of_;  ///< Keywords.
  Tally flat_faces_, zero_normals_;
  std::vector<Corner> corners_;  ///< Of the face at hand, as the next two.
  std::vector<Vec3> polygon_;
  PolygonCutter cutter_;
};

}  // namespace candela
