#include "scene_spec/param_messages.h"

#include <fmt/format.h>

#include "base/text.h"

namespace candela {

std::string WrongWord(std::string_view name, std::string_view expected, std::string_view found,
                      bool is_too_large) {
  return fmt::format("'{}' expects {}, found {}{}", name, expected, Quote(found),
                     is_too_large ? ", which is too large" : "");
}

std::string WrongCount(std::string_view name, std::string_view expected, size_t found) {
  return fmt::format(
      "'{}' expects {}, found {}", name, expected,
      found == 0 ? "nothing" : fmt::format("{} number{}", found, found == 1 ? "" : "s"));
}

const Param* WordBetweenNumbers(const ParamSet& set, size_t i,
                                std::span<const std::string_view> known) {
  if (i + 1 == set.params.size() || set.params[i].words.empty()) return nullptr;
  const Param& next = set.params[i + 1];
  return Nearest(next.name, known) ? nullptr : &next;
}

}  // namespace candela
