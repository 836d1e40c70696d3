#include "loaders/course/read_sky.h"

#include <fmt/format.h>

namespace candela {
namespace {

constexpr std::string_view kSkies[] = {"daylight"};

float NumberFromTo(ParamReader* reader, std::string_view name, float least, float most,
                   float default_value) {
  const float value = reader->Number(name, default_value);
  if (value >= least && value <= most) return value;
  reader->Error(reader->Where(name), fmt::format("'{}' expects a number from {} to {}, found '{}'",
                                                 name, least, most, value));
  return default_value;
}

}  // namespace

std::optional<SkySpec> ReadSky(ParamReader* reader) {
  SkySpec sky;
  reader->Choice("sky", kSkies, 0);
  sky.turbidity = NumberFromTo(reader, "turbidity", SkySpec::kLeastTurbidity,
                               SkySpec::kMostTurbidity, sky.turbidity);
  sky.sun_elevation_degrees =
      NumberFromTo(reader, "sun_elevation", 0, 90, sky.sun_elevation_degrees);
  sky.sun_azimuth_degrees = reader->Number("sun_azimuth", sky.sun_azimuth_degrees);
  sky.ground_albedo = reader->Albedo("ground_albedo", sky.ground_albedo);
  sky.has_sun = reader->Flag("sun", sky.has_sun);
  if (reader->Has("sky")) {
    if (reader->Has("cube_map") || reader->Has("environment")) {
      reader->Error(reader->Where("sky"),
                    "a background has a 'sky', a 'cube_map' or an 'environment': one of them");
    }
    return sky;
  }
  for (const std::string_view name :
       {"turbidity", "sun_elevation", "sun_azimuth", "ground_albedo", "sun"}) {
    if (!reader->Has(name)) continue;
    reader->Error(reader->Where(name),
                  fmt::format("'{}' is for a 'sky', of which there is none", name));
  }
  return std::nullopt;
}

}  // namespace candela
