#pragma once

#include <cstddef>
#include <string>

#include "base/source_location.h"

namespace candela {

class ParamReader;

/// The group of a light, whose light can be had in a layer of its own.
struct LightGroup {
  /// The group of what is in no other.
  static constexpr const char* kDefault = "default";
  /// Of a scene, with that.
  static constexpr size_t kMostGroups = 16;

  std::string name = kDefault;
  SourceLocation where;  ///< Of the name, or of the light without one; for messages.
};

/// Reads the parameter `group`: a name of letters, digits and _, of at most 64 characters, since
/// it becomes a part of the names of channels.
LightGroup ReadLightGroup(ParamReader* params);

}  // namespace candela
