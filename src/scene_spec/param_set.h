#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/source_location.h"

namespace candela {

/// One word of a parameter's value, as it was written.
struct ParamWord {
  std::string text;
  SourceLocation where;
};

/// A named parameter with its words: numbers, or one word or path.
struct Param {
  std::string name;
  SourceLocation where;
  std::vector<ParamWord> words;
  bool is_path = false;  ///< Known once the parameter was asked for.
};

/// The parameters of one object in the order they were written. A name may repeat; the last one
/// counts. Meaning is given to them by a `ParamReader`.
struct ParamSet {
  std::vector<Param> params;
  /// True when something in the block could not be read, which was reported: a parameter that is
  /// missing may have stood there.
  bool is_damaged = false;

  /// The last parameter of that name, or null.
  const Param* Find(std::string_view name) const;
};

/// An object of some kind as a scene describes it: its type and the parameters of that type.
struct TypedSpec {
  std::string type;
  SourceLocation where;  ///< Of the type's name, or of the object where the type is implied.
  ParamSet params;
};

}  // namespace candela
