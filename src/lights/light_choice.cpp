#include "lights/light_choice.h"

#include <algorithm>

namespace candela {
namespace {

constexpr LightChoiceEntry kLightChoices[] = {
    {"effect", LightChoice::kByEffect,
     "by what each may give there, with more than 128 lights by way of a tree"},
    {"power", LightChoice::kByPower, "by power alone"},
    {"uniform", LightChoice::kUniform, "all alike"},
};

}  // namespace

std::span<const LightChoiceEntry> LightChoices() {
  return kLightChoices;
}

const LightChoiceEntry* FindLightChoice(std::string_view name) {
  const auto found = std::ranges::find(kLightChoices, name, &LightChoiceEntry::name);
  return found == std::end(kLightChoices) ? nullptr : found;
}

const LightChoiceEntry& EntryOf(LightChoice choice) {
  return *std::ranges::find(kLightChoices, choice, &LightChoiceEntry::choice);
}

}  // namespace candela
