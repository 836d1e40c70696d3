#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "loaders/obj/obj_reader.h"

namespace candela {

/// A text that was read as "a.obj", and what there was to say about it.
struct ReadText {
  MeshSpec mesh;
  std::vector<std::string> lines;
};

inline ReadText ReadObjText(std::string_view text) {
  Diagnostics diagnostics;
  MeshSpec mesh = ParseObj(std::make_shared<const std::string>("a.obj"), text, &diagnostics);
  return {std::move(mesh), diagnostics.Lines()};
}

}  // namespace candela
