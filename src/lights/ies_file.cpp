#include "lights/ies_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/files.h"
#include "base/text.h"
#include "lights/ies_parser.h"

namespace candela {

float IesFile::TiltFactor(double degrees) const {
  if (tilt_angles.empty()) return 1;
  const auto above = std::find_if(tilt_angles.begin(), tilt_angles.end(),
                                  [&](float angle) { return double{angle} >= degrees; });
  if (above == tilt_angles.begin()) return tilt_factors.front();
  if (above == tilt_angles.end()) return tilt_factors.back();
  const auto i = static_cast<size_t>(above - tilt_angles.begin());
  const double first = double{tilt_angles[i - 1]}, last = double{tilt_angles[i]};
  const double t = (degrees - first) / (last - first);
  return static_cast<float>(double{tilt_factors[i - 1]} * (1 - t) + double{tilt_factors[i]} * t);
}

std::optional<IesFile> ParseIes(std::shared_ptr<const std::string> file, std::string_view text,
                                Diagnostics* diagnostics) {
  return IesParser(std::move(file), text, diagnostics).Parse();
}

std::shared_ptr<const IesFile> ReadIesFile(const std::filesystem::path& path,
                                           const SourceLocation& asked, IesFiles* known,
                                           Diagnostics* diagnostics) {
  if (known) {
    if (const auto found = known->find(path); found != known->end()) return found->second;
  }
  std::shared_ptr<const IesFile> lamp;
  if (const Result<std::string> text = ReadFile(path); !text) {
    diagnostics->Error(asked, fmt::format("ies {}: {}", Quote(path.string()), text.error().message),
                       text.error().code);
  } else if (auto parsed =
                 ParseIes(std::make_shared<const std::string>(path.string()), *text, diagnostics)) {
    lamp = std::make_shared<const IesFile>(*std::move(parsed));
  }
  if (known) known->emplace(path, lamp);
  return lamp;
}

}  // namespace candela
