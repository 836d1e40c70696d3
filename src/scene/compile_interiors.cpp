#include "scene/compile_interiors.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "base/text.h"
#include "scene/resolved_params.h"
#include "scene_spec/param_reader.h"

namespace candela {
namespace {

constexpr int64_t kGreatestPriority = 1000;

class InteriorCompiler {
 public:
  InteriorCompiler(const SceneSpec& spec, Diagnostics* diagnostics, SceneSpec* resolved)
      : spec_(spec), diagnostics_(*diagnostics), resolved_(resolved) {}

  CompiledInteriors Compile() {
    for (size_t i = 0; i < spec_.media.size(); ++i) {
      const MediumSpec& spec = spec_.media[i];
      ParamReader params(spec.params, "Medium", spec.where, &diagnostics_,
                         resolved_ ? Emptied(&resolved_->media[i].params) : nullptr);
      const Medium medium = Medium::Create(&params, 1);
      params.Finish();
      medium_by_name_.try_emplace(spec.name, medium);
    }
    CompiledInteriors interiors;
    for (size_t i = 0; i < spec_.nodes.size(); ++i) {
      interiors.of_node.push_back(spec_.nodes[i].interior ? InteriorOf(i) : std::nullopt);
      if (interiors.of_node.back()) Add(interiors.of_node.back()->medium, &interiors.media);
    }
    if (!interiors.media.empty()) Add(kAir, &interiors.media);
    return interiors;
  }

 private:
  static void Add(const Medium& medium, std::vector<Medium>* media) {
    const bool is_there = std::any_of(media->begin(), media->end(), [&](const Medium& other) {
      return other.RefractsAs(medium);
    });
    if (!is_there) media->push_back(medium);
  }

  std::optional<Interior> InteriorOf(size_t index) {
    const NodeSpec& node = spec_.nodes[index];
    const InteriorSpec& spec = *node.interior;
    ParamReader params(spec.params, "Component<Interior>", spec.where, &diagnostics_,
                       resolved_ ? Emptied(&resolved_->nodes[index].interior->params) : nullptr);
    const std::string name = params.RequiredWord("medium");
    const auto medium = name.empty() ? std::nullopt : MediumNamed(name, params.Where("medium"));
    Interior interior;
    interior.is_explicit = true;
    interior.priority = static_cast<int>(params.Integer("priority", 0, 0, kGreatestPriority));
    params.Finish();
    if (!node.object) {
      diagnostics_.Error(spec.where, "there is no object in this node that could be filled");
    }
    if (!medium) return std::nullopt;
    interior.medium = *medium;
    return interior;
  }

  std::optional<Medium> MediumNamed(std::string_view name, const SourceLocation& where) {
    const auto found = medium_by_name_.find(name);
    if (found != medium_by_name_.end()) return found->second;
    std::vector<std::string_view> names;
    for (const auto& [known, medium] : medium_by_name_) names.push_back(known);
    for (const NamedNumber& substance : Medium::Substances()) {
      if (substance.name == name) return Medium{substance.value, {}};
      names.push_back(substance.name);
    }
    if (!spec_.media_are_damaged) {
      diagnostics_.Error(where, [&] {
        return fmt::format("there is no medium named {}{}", Quote(name), DidYouMean(name, names));
      });
    }
    return std::nullopt;
  }

  const SceneSpec& spec_;
  Diagnostics& diagnostics_;
  SceneSpec* resolved_;
  std::map<std::string_view, Medium> medium_by_name_;
};

}  // namespace

CompiledInteriors CompileInteriors(const SceneSpec& spec, Diagnostics* diagnostics,
                                   SceneSpec* resolved) {
  return InteriorCompiler(spec, diagnostics, resolved).Compile();
}

}  // namespace candela
