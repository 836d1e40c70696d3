#include "scene_spec/light_group.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "base/text.h"
#include "scene_spec/param_reader.h"

namespace candela {
namespace {

constexpr size_t kLongestName = 64;

/// Not by the functions of the C library, which ask for the language of the user.
bool IsOfNames(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

LightGroup ReadLightGroup(ParamReader* params) {
  LightGroup group;
  group.where = params->Where("group");
  if (!params->Has("group")) return group;
  const std::string name = params->Word("group");
  if (name.empty()) return group;  // Which was reported.
  if (name.size() > kLongestName || !std::ranges::all_of(name, IsOfNames)) {
    params->Error(group.where,
                  fmt::format("'group' expects a name of at most {} letters, digits and '_', "
                              "found {}",
                              kLongestName, Quote(name)));
    return group;
  }
  group.name = name;
  return group;
}

}  // namespace candela
