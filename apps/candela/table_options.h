#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "driver/arg_value.h"
#include "film/layers.h"

namespace candela {

// What `candela render` may be given by name, from the tables of the library: the names, and for
// the help what each of them is.

std::vector<std::string_view> IntegratorNames();
std::string IntegratorSummaries();
std::vector<std::string_view> DebugViewNames();
std::string DebugViewSummaries();
std::vector<std::string_view> LightChoiceNames();
std::string LightChoiceSummaries();
std::vector<std::string_view> ToneCurveNames();
std::string ToneCurveSummaries();
std::vector<std::string_view> SamplerNames();
std::string SamplerSummaries();
std::vector<std::string_view> FilterNames();
std::vector<std::string_view> AcceleratorNames();
std::string AcceleratorSummaries();

/// Layers by name, separated by commas, or `all`.
ArgValue LayerNames(LayerSet* target);
std::string LayerSummaries();

}  // namespace candela
