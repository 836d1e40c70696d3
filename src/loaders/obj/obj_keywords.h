#pragma once

#include <string>
#include <string_view>

namespace candela {

/// What a line of an OBJ file is, by its first word.
enum class ObjLine {
  kPosition,      ///< v
  kNormal,        ///< vn
  kTexture,       ///< vt: checked, has no effect
  kFace,          ///< f, and fo of old files
  kMaterialFile,  ///< mtllib
  kMaterial,      ///< usemtl
  kNoEffect,      ///< Grouping, display and surface attributes.
  kLeftOut,  ///< Geometry that is not read: points, lines, curves, surfaces, patches, other files.
  kUnknown,
};

ObjLine FindObjLine(std::string_view keyword);

/// What the warning of a line that is left out or unknown says.
std::string ObjLineWarning(std::string_view keyword);

}  // namespace candela
