#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "scene_spec/param_set.h"

namespace candela {

/// For messages about a parameter's value: "'radius' expects a positive number, found 'x'".
std::string WrongWord(std::string_view name, std::string_view expected, std::string_view found,
                      bool is_too_large = false);

/// The same for a wrong number of numbers.
std::string WrongCount(std::string_view name, std::string_view expected, size_t found);

/// Of a parameter with too few numbers, the i-th of its set: the one behind it, if that is none but
/// a word in the place of a number. A word between numbers reads like the name of a further
/// parameter; one that resembles no name in `known` is meant as a value. Null otherwise.
const Param* WordBetweenNumbers(const ParamSet& set, size_t i,
                                std::span<const std::string_view> known);

}  // namespace candela
