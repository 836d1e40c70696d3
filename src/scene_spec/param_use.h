#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "scene_spec/param_set.h"

namespace candela {

/// Which parameters of a set were asked for, and what there is to say about that in the end: names
/// that nobody knows, values that are missing. The two together, since a misspelt name is both.
class ParamUse {
 public:
  /// See `ParamReader`. All arguments must outlive it.
  ParamUse(const ParamSet& params, std::string_view object, const SourceLocation& where,
           Diagnostics* diagnostics)
      : params_(params), object_(object), where_(where), diagnostics_(*diagnostics) {}

  /// Somebody asks for the parameter. Whether it is there.
  bool Know(std::string_view name);
  /// And it has to be there.
  bool Require(std::string_view name);
  /// It has fewer values than it needs.
  void AddShortage(const Param& param, std::string expected);

  void Report();

 private:
  struct Shortage {
    const Param* param;
    std::string expected;
  };

  void ReportShortage(const Shortage& shortage, const Param* word_instead);
  void ReportUnused(const Param& param);
  void ReportMissing();

  const ParamSet& params_;
  std::string_view object_;
  const SourceLocation& where_;
  Diagnostics& diagnostics_;
  std::vector<std::string_view> known_;
  std::vector<std::string_view> missing_;
  std::vector<Shortage> shortages_;
};

}  // namespace candela
