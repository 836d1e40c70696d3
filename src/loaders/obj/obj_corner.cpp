#include "loaders/obj/obj_corner.h"

#include "base/number.h"

namespace candela {

std::optional<ObjCorner> ParseObjCorner(std::string_view text) {
  constexpr size_t kNone = std::string_view::npos;
  ObjCorner corner;
  const size_t first = text.find('/');
  const auto position = ParseInteger(text.substr(0, first));
  if (!position) return std::nullopt;
  corner.position = *position;
  if (first == kNone) return corner;

  text.remove_prefix(first + 1);
  const size_t second = text.find('/');
  // Only "v//vn" leaves an index out.
  if (second != 0 && !(corner.texture = ParseInteger(text.substr(0, second)))) return std::nullopt;
  if (second != kNone && !(corner.normal = ParseInteger(text.substr(second + 1)))) {
    return std::nullopt;
  }
  return corner;
}

}  // namespace candela
