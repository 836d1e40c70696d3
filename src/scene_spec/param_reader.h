#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "math/spectrum.h"
#include "math/vec.h"
#include "scene_spec/param_set.h"

namespace candela {

/// Gives meaning to a `ParamSet`: each call asks for one parameter, and what is wrong with it goes
/// to the diagnostics while reading goes on with a usable value. Remembers what was asked for, so
/// that `Finish` can report parameters that nobody knows.
///
/// The calls with a default return it when the parameter is missing; the `Required` ones report it.
class ParamReader {
 public:
  /// `object` names what is read for messages, as in "is not used by 'sphere'". `where` is the
  /// place of the object, for parameters that are missing. All arguments must outlive the reader.
  ParamReader(const ParamSet& params, std::string_view object, const SourceLocation& where,
              Diagnostics* diagnostics);

  float Number(std::string_view name, float default_value);
  float RequiredNumber(std::string_view name);
  float Positive(std::string_view name, float default_value);
  float RequiredPositive(std::string_view name);
  float NonNegative(std::string_view name, float default_value);
  /// Strictly between 0 and 180.
  float RequiredAngle(std::string_view name);
  int64_t RequiredInteger(std::string_view name);

  Vec3 Vector(std::string_view name, Vec3 default_value);
  Vec3 RequiredVector(std::string_view name);
  /// Three numbers of which at least one is not 0.
  Vec3 RequiredDirection(std::string_view name);
  Rgb Color(std::string_view name, Rgb default_value);

  /// One word or path, as written; empty when it is missing.
  std::string Word(std::string_view name);
  std::string RequiredWord(std::string_view name);

  bool Has(std::string_view name);
  /// The place of the parameter's value, or of the object when it is missing.
  SourceLocation Where(std::string_view name) const;

  void Error(SourceLocation where, std::string text);

  /// Reports parameters that were given but never asked for.
  void Finish();

 private:
  /// The parameter, remembered as known; reports a required one that is missing.
  const Param* Ask(std::string_view name, bool is_required);
  std::optional<float> OneNumber(std::string_view name, bool is_required, const char* expected,
                                 bool (*is_legal)(float));
  std::optional<Vec3> ThreeNumbers(std::string_view name, bool is_required);
  void Mismatch(const Param& param, const char* expected);

  const ParamSet& params_;
  std::string_view object_;
  const SourceLocation& where_;
  Diagnostics* diagnostics_;
  std::vector<std::string_view> known_;
};

}  // namespace candela
