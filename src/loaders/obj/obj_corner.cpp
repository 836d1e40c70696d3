#include "loaders/obj/obj_corner.h"

#include "base/number.h"

namespace candela {
namespace {

/// As `text.find('/')`, which would call a function for two or three characters.
size_t FindSlash(std::string_view text) {
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '/') return i;
  }
  return std::string_view::npos;
}

}  // namespace

std::optional<ObjCorner> ParseObjCorner(std::string_view text) {
  constexpr size_t kNone = std::string_view::npos;
  ObjCorner corner;
  const size_t first = FindSlash(text);
  const auto position = ParseInteger(text.substr(0, first));
  if (!position) return std::nullopt;
  corner.position = *position;
  if (first == kNone) return corner;

  text.remove_prefix(first + 1);
  const size_t second = FindSlash(text);
  // Only "v//vn" leaves an index out.
  if (second != 0 && !(corner.texture = ParseInteger(text.substr(0, second)))) return std::nullopt;
  if (second != kNone && !(corner.normal = ParseInteger(text.substr(second + 1)))) {
    return std::nullopt;
  }
  return corner;
}

}  // namespace candela
