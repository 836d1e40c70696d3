#pragma once

#include <cctype>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>

#include "textures/registry.h"

namespace candela::test {

/// A texture of the given type from "name word number ... name word number ...".
inline std::shared_ptr<const Texture> MakeTexture(const std::string& type, const std::string& text,
                                                  const std::filesystem::path& folder,
                                                  Diagnostics* diagnostics) {
  TypedSpec spec{type, {}, {}};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    auto& params = spec.params.params;
    const bool is_value_due = !params.empty() && params.back().words.empty();
    if (!is_value_due && std::isalpha(static_cast<unsigned char>(word[0]))) {
      params.push_back({word, {}, {}});
    } else {
      params.back().words.push_back({word, {}});
    }
  }
  const auto find_file = [&](const ParamWord& path) { return folder / path.text; };
  return CreateTexture(spec, TextureContext{diagnostics, find_file, nullptr});
}

/// A point with these texture coordinates.
inline SurfacePoint At(float u, float v) {
  SurfacePoint point;
  point.uv = {u, v};
  return point;
}

}  // namespace candela::test
