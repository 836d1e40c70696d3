#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace candela::same_light {

/// A small scene, in which some way to transport light is at work.
struct NamedScene {
  std::string name;
  std::string text;
};

/// Each kind of light, material and camera is in one at least.
std::vector<NamedScene> Scenes();

inline void PrintTo(const NamedScene& scene, std::ostream* out) {
  *out << scene.name;
}

}  // namespace candela::same_light
