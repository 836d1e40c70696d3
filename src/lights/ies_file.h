#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "lights/ies_profile.h"
#include "scene_spec/param_set.h"

namespace candela {

/// What a photometric file says of a lamp: ANSI/IESNA LM-63 "Standard File Format for the
/// Electronic Transfer of Photometric Data", of 1986, 1991, 1995, 2002 and 2019.
struct IesFile {
  IesProfile profile;

  /// What is left of the light when the lamp is tilted by angles, in degrees; none where it is the
  /// same. Angles grow strictly from one to the next.
  std::vector<float> tilt_angles = {}, tilt_factors = {};

  /// That for an angle, between those of the file and beyond their ends.
  float TiltFactor(double degrees) const;
};

/// Reads such a text. Nothing when something is wrong with it, which is reported at its place in
/// `file`, the name for messages.
std::optional<IesFile> ParseIes(std::shared_ptr<const std::string> file, std::string_view text,
                                Diagnostics* diagnostics);

/// The files that were read, by path; null for those that are wrong.
using IesFiles = std::map<std::filesystem::path, std::shared_ptr<const IesFile>>;

/// Reads a file, unless `known` has it, which may be null and else gets it. Null when it cannot be
/// read, which is reported at `asked`, the place that asks for it, or when it is wrong, which is
/// reported once.
std::shared_ptr<const IesFile> ReadIesFile(const std::filesystem::path& path,
                                           const SourceLocation& asked, IesFiles* known,
                                           Diagnostics* diagnostics);

}  // namespace candela
