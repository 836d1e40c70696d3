#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "base/diagnostics.h"
#include "lights/light.h"
#include "lights/light_context.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// A kind of light that scenes may name.
struct LightEntry {
  std::string_view name;
  std::unique_ptr<Light> (*create)(ParamReader* params, const LightContext& context);
  /// The body of a `Component<Light>` that the contract tests and the manual use.
  std::string_view example;
};

std::span<const LightEntry> LightEntries();

/// Creates the light that `spec` describes; null when there is no such kind.
std::unique_ptr<Light> CreateLight(const TypedSpec& spec, const LightContext& context,
                                   Diagnostics* diagnostics);

}  // namespace candela
