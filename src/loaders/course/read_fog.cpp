#include "loaders/course/read_fog.h"

#include <fmt/format.h>

namespace candela {

std::optional<FogSpec> ReadFog(ParamReader* reader) {
  FogSpec fog;
  fog.profile = FogSpec::Profile(reader->Choice("fog", FogSpec::kProfileWords, 0));
  fog.color = reader->NonNegativeColor("fog_color", fog.color);
  fog.density = reader->NonNegative("fog_density", fog.density);
  fog.base = reader->Number("fog_base", fog.base);
  fog.height = reader->Positive("fog_height", fog.height);
  fog.where = reader->Where("fog");
  if (!reader->Has("fog")) {
    for (const std::string_view name : {"fog_color", "fog_density", "fog_base", "fog_height"}) {
      if (!reader->Has(name)) continue;
      reader->Error(reader->Where(name),
                    fmt::format("'{}' is for a 'fog', of which there is none", name));
    }
    return std::nullopt;
  }
  reader->HasRequired("fog_density");
  const bool has_levels = fog.profile != FogSpec::Profile::kHomogeneous;
  if (has_levels) reader->HasRequired("fog_height");
  for (const std::string_view name : {"fog_base", "fog_height"}) {
    if (has_levels || !reader->Has(name)) continue;
    reader->Error(reader->Where(name),
                  fmt::format("'{}' has no meaning in a fog that is the same everywhere", name));
  }
  return fog;
}

}  // namespace candela
