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
#include "scene_spec/param_use.h"

namespace candela {

/// A name that may stand for a number.
struct NamedNumber {
  std::string_view name;
  float value;
};

/// Gives meaning to a `ParamSet`: each call asks for one parameter, and what is wrong with it goes
/// to the diagnostics while reading goes on with a usable value. Where a name repeats, the last one
/// counts and all of them have to be right. Once everything was asked for, `Finish` reports what is
/// missing and what nobody asked for; the two together, since a misspelt name is both.
///
/// The calls with a default return it when the parameter is missing; for the `Required` ones it is
/// then wrong. A default is what would be the same if it was written: where a parameter means
/// something else when it is missing, `Has` tells, and it is not asked for.
class ParamReader {
 public:
  /// `object` names what is read for messages, as in "is not used by 'sphere'". `where` is the
  /// place of the object, for parameters that are missing. `resolved`, where it is not null, gets
  /// each parameter that is asked for, with the value that was returned. All arguments must outlive
  /// the reader.
  ParamReader(const ParamSet& params, std::string_view object, const SourceLocation& where,
              Diagnostics* diagnostics, ParamSet* resolved = nullptr);

  float Number(std::string_view name, float default_value);
  float RequiredNumber(std::string_view name);
  float Positive(std::string_view name, float default_value);
  float RequiredPositive(std::string_view name);
  float NonNegative(std::string_view name, float default_value);
  /// From 0 to 1.
  float Fraction(std::string_view name, float default_value);
  /// Strictly between 0 and 180.
  float RequiredAngle(std::string_view name);
  /// Above 0 and at most 180, or at most 360.
  float HalfAngle(std::string_view name, float default_value);
  float FullAngle(std::string_view name, float default_value);
  /// Nothing when it is missing or wrong.
  std::optional<int64_t> RequiredInteger(std::string_view name);

  /// A whole number from `least` to `most`.
  int64_t Integer(std::string_view name, int64_t default_value, int64_t least, int64_t most);

  /// Groups of so many numbers, at least one, behind each other; empty when it is missing or wrong.
  /// `expected` is what a message says that the parameter expects.
  std::vector<float> RequiredNumberGroups(std::string_view name, size_t group_size,
                                          const char* expected);

  Vec2 Pair(std::string_view name, Vec2 default_value);
  Vec3 Vector(std::string_view name, Vec3 default_value);
  Vec3 RequiredVector(std::string_view name);
  /// Three numbers of which at least one is not 0.
  Vec3 RequiredDirection(std::string_view name);
  Rgb Color(std::string_view name, Rgb default_value);
  /// Each number at least 0.
  Rgb NonNegativeColor(std::string_view name, Rgb default_value);
  /// Each number from 0 to 1.
  Rgb Albedo(std::string_view name, Rgb default_value);

  /// A positive number, or a name that stands for one.
  float PositiveOrNamed(std::string_view name, std::span<const NamedNumber> names,
                        float default_value);
  /// `true` or `false`.
  bool Flag(std::string_view name, bool default_value);

  /// One word or path, as written; empty when it is missing or wrong.
  std::string Word(std::string_view name);
  std::string RequiredWord(std::string_view name);
  /// The place of one of `words` in their list.
  size_t Choice(std::string_view name, std::span<const std::string_view> words,
                size_t default_value);
  /// One path with its place, as `SceneSpec::PathInScene` takes it; empty when it is missing or
  /// wrong.
  ParamWord Path(std::string_view name);
  ParamWord RequiredPath(std::string_view name);

  /// Whether a texture stands in place of the value, as in `diffuse texture wood`.
  bool IsTexture(std::string_view name);
  /// Its name; null when that is missing, which is reported.
  const ParamWord* TextureName(std::string_view name);

  bool Has(std::string_view name) { return use_.Know(name); }
  /// The same of a parameter that has to be there.
  bool HasRequired(std::string_view name) { return use_.Require(name); }
  /// The place of the parameter's value, or of the object when it is missing.
  SourceLocation Where(std::string_view name) const;

  void Error(SourceLocation where, std::string text);

  /// Reports parameters that are missing, and those that were given but never asked for.
  void Finish() { use_.Report(); }

 private:
  struct NumberRule {
    const char* expected;     ///< For messages.
    bool (*is_legal)(float);  ///< For each number.
  };
  struct IntegerRule {
    std::string expected;
    int64_t least, most;
  };

  /// The value that `read` finds in the last parameter of that name; remembers the name as known.
  template <class Read>
  auto ReadEach(std::string_view name, bool is_required, const Read& read);
  std::optional<float> OneNumber(std::string_view name, bool is_required, const NumberRule& rule);
  std::optional<Vec3> ThreeNumbers(std::string_view name, bool is_required, const NumberRule& rule);
  std::optional<int64_t> OneInteger(std::string_view name, bool is_required,
                                    const IntegerRule& rule);
  bool ReadNumbers(const Param& param, const NumberRule& rule, std::span<float> values);
  std::optional<ParamWord> OneWord(const Param& param);
  ParamWord PlacedWord(std::string_view name, bool is_required);
  void Note(std::string_view name, std::vector<ParamWord> words, bool is_path = false);
  float Noted(std::string_view name, float value);
  Vec2 Noted(std::string_view name, Vec2 value);
  Vec3 Noted(std::string_view name, Vec3 value);

  const ParamSet& params_;
  const SourceLocation& where_;
  Diagnostics* diagnostics_;
  ParamSet* resolved_;
  ParamUse use_;
};

}  // namespace candela
