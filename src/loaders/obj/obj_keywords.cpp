#include "loaders/obj/obj_keywords.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "base/text.h"

namespace candela {
namespace {

struct Entry {
  std::string_view keyword;
  ObjLine line;
  std::string_view left_out = {};  ///< What such lines describe, for the warning.
};

// The keywords of Wavefront's "Object Files" appendix, version 3.0, and the older ones that it
// lists as superseded. The first four make up nearly every file.
constexpr Entry kEntries[] = {
    {"v", ObjLine::kPosition},
    {"f", ObjLine::kFace},
    {"vn", ObjLine::kNormal},
    {"vt", ObjLine::kTexture},
    {"fo", ObjLine::kFace},
    {"mtllib", ObjLine::kMaterialFile},
    {"usemtl", ObjLine::kMaterial},
    {"p", ObjLine::kLeftOut, "points"},
    {"l", ObjLine::kLeftOut, "lines"},
    {"curv", ObjLine::kLeftOut, "curves"},
    {"curv2", ObjLine::kLeftOut, "curves"},
    {"surf", ObjLine::kLeftOut, "free-form surfaces"},
    {"bsp", ObjLine::kLeftOut, "patches"},
    {"bzp", ObjLine::kLeftOut, "patches"},
    {"cdc", ObjLine::kLeftOut, "curves"},
    {"cdp", ObjLine::kLeftOut, "patches"},
    {"call", ObjLine::kLeftOut, "other files"},
    {"csh", ObjLine::kLeftOut, "shell commands"},
    {"o", ObjLine::kNoEffect},
    {"g", ObjLine::kNoEffect},
    {"s", ObjLine::kNoEffect},
    {"mg", ObjLine::kNoEffect},
    {"vp", ObjLine::kNoEffect},
    {"cstype", ObjLine::kNoEffect},
    {"deg", ObjLine::kNoEffect},
    {"bmat", ObjLine::kNoEffect},
    {"step", ObjLine::kNoEffect},
    {"parm", ObjLine::kNoEffect},
    {"trim", ObjLine::kNoEffect},
    {"hole", ObjLine::kNoEffect},
    {"scrv", ObjLine::kNoEffect},
    {"sp", ObjLine::kNoEffect},
    {"end", ObjLine::kNoEffect},
    {"con", ObjLine::kNoEffect},
    {"bevel", ObjLine::kNoEffect},
    {"c_interp", ObjLine::kNoEffect},
    {"d_interp", ObjLine::kNoEffect},
    {"lod", ObjLine::kNoEffect},
    {"maplib", ObjLine::kNoEffect},
    {"usemap", ObjLine::kNoEffect},
    {"shadow_obj", ObjLine::kNoEffect},
    {"trace_obj", ObjLine::kNoEffect},
    {"ctech", ObjLine::kNoEffect},
    {"stech", ObjLine::kNoEffect},
    {"res", ObjLine::kNoEffect},
};

const Entry* Find(std::string_view keyword) {
  const Entry* found = std::find_if(std::begin(kEntries), std::end(kEntries),
                                    [&](const Entry& entry) { return entry.keyword == keyword; });
  return found == std::end(kEntries) ? nullptr : found;
}

}  // namespace

ObjLine FindObjLine(std::string_view keyword) {
  const Entry* entry = Find(keyword);
  return entry ? entry->line : ObjLine::kUnknown;
}

std::string ObjLineWarning(std::string_view keyword) {
  if (const Entry* entry = Find(keyword)) {
    return fmt::format("'{}': {} are left out", keyword, entry->left_out);
  }
  std::array<std::string_view, std::size(kEntries)> known;
  std::transform(std::begin(kEntries), std::end(kEntries), known.begin(),
                 [](const Entry& entry) { return entry.keyword; });
  return fmt::format("unknown keyword {}{}; such lines are left out", Quote(keyword),
                     DidYouMean(keyword, known));
}

}  // namespace candela
