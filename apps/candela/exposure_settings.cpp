#include "candela/exposure_settings.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "base/text.h"
#include "math/elementary.h"

namespace candela {
namespace {

constexpr ArgTraits kInFilm{.block = "Film"};
constexpr float kUsualIso = 100;

/// The numbers of a camera, as options and as scenes write them.
struct Number {
  const char *option, *param;
};
constexpr Number kNumbers[] = {{"iso", "iso"}, {"f-stop", "f_stop"}, {"shutter", "shutter"}};

}  // namespace

void ExposureSettings::Add(ArgParser* parser) {
  parser->Option("exposure", {Real("EV", &exposure_)},
                 "brightness of .png and .jpg files in stops: 1 doubles the light (default 0)",
                 kInFilm);
  parser->Option("iso", {Positive("S", &iso_)},
                 "in place of --exposure, the brightness that a camera gives to light in candela "
                 "per square metre, with --f-stop and --shutter: the sensitivity of its film "
                 "(default 100)",
                 kInFilm);
  parser->Option("f-stop", {Positive("N", &f_stop_)},
                 "the focal length over the width of its lens; changes the brightness alone",
                 kInFilm);
  parser->Option("shutter", {Positive("SECONDS", &shutter_)}, "how long it is open", kInFilm);
}

void ExposureSettings::Merge(const ArgParser& parser, const ParamSet& film,
                             Diagnostics* diagnostics) {
  const Param* number = nullptr;
  bool is_in_options = false;
  for (const Number& each : kNumbers) {
    if (!number) number = film.Find(each.param);
    is_in_options = is_in_options || parser.Has(each.option);
  }
  if (number && film.Find("exposure")) {
    diagnostics->Error(number->where,
                       fmt::format("'{}' and 'exposure': give one of them", number->name));
    return;
  }
  if (parser.Has("exposure")) iso_ = f_stop_ = shutter_ = std::nullopt;
  if (is_in_options) exposure_.reset();
  if (!number || !HasPhotographic()) return;
  // One that stands there but is wrong has been reported.
  std::vector<std::string_view> missing;
  if (!f_stop_ && !film.Find("f_stop")) missing.push_back("f_stop");
  if (!shutter_ && !film.Find("shutter")) missing.push_back("shutter");
  if (missing.empty()) return;
  diagnostics->Error(number->where,
                     fmt::format("'{}' needs {} beside it", number->name, ListOf(missing, "and")));
}

Result<void> ExposureSettings::Check(const ArgParser& parser) const {
  for (const Number& each : kNumbers) {
    if (!parser.Has(each.option)) continue;
    if (parser.Has("exposure")) {
      return UsageError(fmt::format("--exposure and --{}: give one of them", each.option));
    }
    if (IsPhotographic()) continue;
    return UsageError(
        fmt::format("--{}: an exposure as a camera has it takes --f-stop and "
                    "--shutter",
                    each.option));
  }
  return {};
}

// ISO 12232:2006, by the speed S that lets film saturate: with the luminance L, the f-number N, the
// time t and the share q = 0.65 of the light that lenses let through, its exposure is H = q L t /
// N^2, and it is saturated at H = 78 / S. What saturates it is 1 in the picture.
float ExposureSettings::Gain() const {
  if (!IsPhotographic()) return Exp2(Stops());
  constexpr double kTransmitted = 0.65, kSaturating = 78;
  const double n = static_cast<double>(*f_stop_), t = static_cast<double>(*shutter_);
  const auto iso = static_cast<double>(iso_.value_or(kUsualIso));
  return static_cast<float>(kTransmitted * t * iso / (kSaturating * n * n));
}

void ExposureSettings::Show(bool shows_stops) {
  if (IsPhotographic()) {
    iso_ = iso_.value_or(kUsualIso);
  } else if (shows_stops) {
    exposure_ = Stops();
  } else {
    exposure_.reset();
  }
}

}  // namespace candela
