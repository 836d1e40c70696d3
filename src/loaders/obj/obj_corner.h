#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace candela {

/// The indices of a face's corner as they are written: from 1, or negative to count backwards. Not
/// checked against any list.
struct ObjCorner {
  int64_t position = 0;
  std::optional<int64_t> texture;
  std::optional<int64_t> normal;
};

/// Reads "v", "v/vt", "v//vn" or "v/vt/vn" of whole numbers; nothing for any other text.
std::optional<ObjCorner> ParseObjCorner(std::string_view text);

}  // namespace candela
