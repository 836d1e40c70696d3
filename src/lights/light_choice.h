#pragma once

#include <span>
#include <string_view>

namespace candela {

/// How a light is chosen for a point.
enum class LightChoice {
  kByEffect,  ///< By what it may give there: its power over the squared distance.
  kUniform,   ///< All alike, for comparison.
  kByPower,   ///< By power alone, wherever the point is; for comparison.
};

/// A row of the table of choices.
struct LightChoiceEntry {
  std::string_view name;  ///< In the command line.
  LightChoice choice;
  std::string_view description;
};

std::span<const LightChoiceEntry> LightChoices();

/// The row of that name, or null.
const LightChoiceEntry* FindLightChoice(std::string_view name);
const LightChoiceEntry& EntryOf(LightChoice choice);

}  // namespace candela
