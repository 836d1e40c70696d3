#include "loaders/course/typed_block.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "base/text.h"
#include "scene_spec/param_reader.h"

namespace candela {
namespace {

constexpr std::string_view kType[] = {"type"};

/// Reports that there is no type, at the word that was meant as its name if there is one.
void ReportNoType(const ParamSet& params, const SourceLocation& where, std::string_view block,
                  Diagnostics* diagnostics) {
  for (const Param& param : params.params) {
    if (!Nearest(param.name, kType)) continue;
    diagnostics->Error(param.where,
                       fmt::format("{} needs 'type', found {}", Quote(block), Quote(param.name)));
    return;
  }
  if (!params.is_damaged) diagnostics->Error(where, fmt::format("{} needs 'type'", Quote(block)));
}

}  // namespace

TypedSpec TakeType(ParamSet params, const SourceLocation& where, std::string_view block,
                   std::string_view default_type, Diagnostics* diagnostics) {
  TypedSpec spec{std::string(default_type), where, {}};
  ParamReader reader(params, block, where, diagnostics);
  if (reader.Has("type")) {
    spec.type = reader.Word("type");
    spec.where = reader.Where("type");
    std::erase_if(params.params, [](const Param& param) { return param.name == "type"; });
  } else if (default_type.empty()) {
    ReportNoType(params, where, block, diagnostics);
  }
  spec.params = std::move(params);
  return spec;
}

}  // namespace candela
