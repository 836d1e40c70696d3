#include "lamp_room.h"

#include <fmt/format.h>

#include <random>

#include "math/elementary.h"

namespace candela {
namespace {

constexpr const char* kRoom =
    "Camera { center 0 1.1 3.8 direction 0 -0.75 -1 up 0 1 0 fov 60 }\n"
    "Materials { Material { type diffuse albedo 0.7 0.7 0.7 } "
    "Material { type diffuse albedo 0.6 0.3 0.2 } }\n"
    "Scene {\n"
    "Node { Transform { translate -1 0 -1 } Component<Object> { type sphere radius 0.6 } "
    "Component<Material> { index 1 } }\n"
    "Node { Transform { translate 1.2 -0.2 0 } Component<Object> { type sphere radius 0.5 } "
    "Component<Material> { index 1 } }\n";

/// The same numbers everywhere.
class Numbers {
 public:
  double Next() { return (bits_() >> 8) * 0x1p-24; }
  double Between(double least, double most) { return least + (most - least) * Next(); }

 private:
  std::mt19937 bits_{1};
};

}  // namespace

std::string LampRoom(uint32_t lamps) {
  std::string text = kRoom;
  for (const char* wall : {"0 1 0 offset -0.5", "0 -1 0 offset -2.5", "1 0 0 offset -4",
                           "-1 0 0 offset -4", "0 0 1 offset -4", "0 0 -1 offset -4"}) {
    text += fmt::format(
        "Node {{ Component<Object> {{ type plane normal {} }} Component<Material> {{ index 0 }} "
        "}}\n",
        wall);
  }
  Numbers numbers;
  for (uint32_t i = 0; i < lamps; ++i) {
    const double x = numbers.Between(-3.9, 3.9), z = numbers.Between(-3.9, 3.9);
    const double radiance = 0.5 / (numbers.Next() + 1e-3);
    const std::string place = fmt::format("{} {} {}", x, numbers.Between(1.2, 2.2), z);
    const char* shape = i % 3 == 0   ? "type sphere radius 0.01"
                        : i % 3 == 1 ? "type rectangle width 0.02 height 0.02"
                                     : "type disk radius 0.012";
    text += fmt::format(
        "Node {{ Transform {{ translate {} x_rotate 90 }} Component<Object> {{ {} }} "
        "Component<Material> {{ index 0 }} Component<Light> {{ type area radiance {} {} {} }} }}\n",
        place, shape, radiance, radiance * 0.9, radiance * 0.7);
  }
  return text + "}\n";
}

}  // namespace candela
