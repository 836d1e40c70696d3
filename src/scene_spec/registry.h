#pragma once

#include <fmt/format.h>

#include <span>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/text.h"
#include "scene_spec/param_set.h"

namespace candela {

/// The row of a table whose `name` is the type of `spec`; null, with an error that lists the known
/// names, when there is none. A missing type has been reported by the loader and stays silent here.
template <class Entry>
const Entry* FindEntry(std::span<const Entry> table, const TypedSpec& spec, std::string_view kind,
                       Diagnostics* diagnostics) {
  std::vector<std::string_view> names;
  for (const Entry& entry : table) {
    if (entry.name == spec.type) return &entry;
    names.push_back(entry.name);
  }
  if (!spec.type.empty()) {
    diagnostics->Error(spec.where,
                       fmt::format("there is no {} of type {}{}; known: {}", kind, Quote(spec.type),
                                   DidYouMean(spec.type, names), ListOf(names)));
  }
  return nullptr;
}

}  // namespace candela
