// Any bytes as a photometric text: reading ends, and a lamp without errors is as bright as it says
// in all directions that it draws.
#include <cmath>
#include <memory>
#include <string>
#include <string_view>

#include "base/check.h"
#include "lights/ies_file.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  using namespace candela;
  Diagnostics diagnostics;
  const auto file =
      ParseIes(std::make_shared<const std::string>("fuzz.ies"),
               std::string_view(reinterpret_cast<const char*>(data), size), &diagnostics);
  for (const std::string& line : diagnostics.Lines()) CHECK(line.size() < 500);
  CHECK(file.has_value() == !diagnostics.HasErrors());
  if (!file) return 0;

  const IesProfile& profile = file->profile;
  CHECK(std::isfinite(profile.Flux()) && profile.Flux() >= 0);
  CHECK(std::isfinite(file->TiltFactor(30)) && file->TiltFactor(30) >= 0);
  for (int i = 0; i < 16; ++i) {
    const Vec2 u{(static_cast<float>(i % 4) + 0.5f) / 4, (static_cast<float>(i / 4) + 0.5f) / 4};
    const IesProfile::Sample drawn = profile.Draw(u);
    CHECK(drawn.pdf > 0 && std::isfinite(drawn.pdf));
    CHECK(std::abs(LengthSquared(drawn.w) - 1) < 1e-5f);
    const float intensity = profile.Intensity(drawn.w);
    CHECK(std::isfinite(intensity) && intensity >= 0);
    CHECK(std::isfinite(profile.Pdf(drawn.w)) && profile.Pdf(drawn.w) >= 0);
  }
  return 0;
}
