#include "candela/table_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "film/pixel_filter.h"
#include "image/tone_curve.h"
#include "integrators/registry.h"
#include "kernel/accelerator_kind.h"
#include "lights/light_choice.h"
#include "sampling/sampler.h"

namespace candela {
namespace {

template <class Table>
std::vector<std::string_view> NamesOf(const Table& table) {
  std::vector<std::string_view> names;
  for (const auto& entry : table) names.push_back(entry.name);
  return names;
}

/// "what it is about; first: what it is; second: ...".
template <class Table>
std::string Summaries(std::string text, const Table& table) {
  for (const auto& entry : table) text += fmt::format("; {}: {}", entry.name, entry.description);
  return text;
}

}  // namespace

std::vector<std::string_view> IntegratorNames() {
  return NamesOf(IntegratorEntries());
}

std::string IntegratorSummaries() {
  return Summaries("how light is computed (default whitted)", IntegratorEntries());
}

std::vector<std::string_view> DebugViewNames() {
  return NamesOf(DebugViews());
}

std::string DebugViewSummaries() {
  return Summaries("with debug: what is shown (default normal)", DebugViews());
}

std::vector<std::string_view> LightChoiceNames() {
  return NamesOf(LightChoices());
}

std::string LightChoiceSummaries() {
  return Summaries(
      "with path, direct and light_trace: how a light is chosen to be sampled from a point; "
      "changes "
      "the noise alone (default effect)",
      LightChoices());
}

std::vector<std::string_view> ToneCurveNames() {
  return NamesOf(ToneCurves());
}

std::string ToneCurveSummaries() {
  return Summaries(
      "how .png and .jpg files show the light (default none, with integrators that draw samples "
      "srgb)",
      ToneCurves());
}

std::vector<std::string_view> SamplerNames() {
  return NamesOf(Samplers());
}

std::string SamplerSummaries() {
  return Summaries("where the random numbers come from (default sobol)", Samplers());
}

std::vector<std::string_view> FilterNames() {
  return NamesOf(PixelFilters());
}

std::vector<std::string_view> AcceleratorNames() {
  return NamesOf(Accelerators());
}

std::string AcceleratorSummaries() {
  return Summaries(
      "what finds the hits, for comparison; changes nothing in the picture (default "
      "bvh)",
      Accelerators());
}

ArgValue LayerNames(LayerSet* target) {
  std::vector<std::string_view> names;
  for (const LayerEntry& entry : Layers()) names.push_back(entry.name);
  names.push_back("all");
  const auto store = [target, names](std::string_view text) {
    LayerSet layers;
    while (true) {
      const std::string_view word = text.substr(0, text.find(','));
      const auto found = std::ranges::find(names, word);
      if (found == names.end()) return false;
      const auto index = static_cast<size_t>(found - names.begin());
      const bool is_all = index == kLayerCount;
      for (size_t i = is_all ? 0 : index; i < (is_all ? kLayerCount : index + 1); ++i) {
        if (!is_all || !Layers()[i].is_of_groups) layers.Add(static_cast<Layer>(i));
      }
      if (word.size() == text.size()) break;
      text.remove_prefix(word.size() + 1);
    }
    *target = layers;
    return true;
  };
  return {"NAMES", ListOf(names) + ", several with commas", store, names};
}

std::string LayerSummaries() {
  return Summaries(
      "layers in the .exr file beside the colours, separated by commas, or all of them but "
      "light_groups",
      Layers());
}

}  // namespace candela
