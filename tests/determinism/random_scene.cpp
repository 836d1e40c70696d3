#include "tests/determinism/random_scene.h"

#include <fmt/format.h>

#include <iterator>
#include <random>
#include <utility>

namespace candela::determinism {
namespace {

/// Writes scenes with numbers from a generator whose sequence the standard fixes; the standard's
/// distributions differ between libraries, so there are none.
class Writer {
 public:
  explicit Writer(uint32_t seed) : random_(seed) {}

  /// Thousandths from `least` to `most`.
  double Number(double least, double most) {
    const auto steps = static_cast<uint32_t>((most - least) * 1000) + 1;
    return least + static_cast<double>(random_() % steps) / 1000;
  }
  uint32_t Below(uint32_t count) { return static_cast<uint32_t>(random_() % count); }

  template <class... Arguments>
  void Add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
  }
  void AddVector(const char* name, double least, double most) {
    // In statements of their own: the order of arguments is not fixed.
    const double x = Number(least, most);
    const double y = Number(least, most);
    const double z = Number(least, most);
    Add("{} {:.3f} {:.3f} {:.3f} ", name, x, y, z);
  }

  std::string TakeText() { return std::move(text_); }

 private:
  std::mt19937 random_;
  std::string text_;
};

void AddCamera(Writer* writer, const char* lens = "") {
  writer->Add("Camera {{ center 0 1 9 direction {:.3f} -0.1 -1 up 0 1 0 fov 40 {} }}\n",
              writer->Number(-0.1, 0.1), lens);
}

/// A plane below everything, a little tilted: in any other place it would hide the rest.
void AddFloor(Writer* writer) {
  writer->Add("Node {{ Component<Material> {{ index 1 }} Component<Object> {{ type plane ");
  writer->Add("normal {:.3f} 1 0.1 ", writer->Number(-0.2, 0.2));
  writer->Add("offset {:.3f} }} }}\n", writer->Number(-3, -2));
}

void AddObject(Writer* writer) {
  if (writer->Below(2) == 0) {
    writer->Add("type sphere radius {:.3f}", writer->Number(0.3, 1));
    return;
  }
  writer->Add("type triangle ");
  for (const char* name : {"vertex0", "vertex1", "vertex2"}) writer->AddVector(name, -1.5, 1.5);
}

void AddTransform(Writer* writer) {
  writer->Add("Transform {{ ");
  writer->AddVector("translate", -2, 2);
  // One draw for each statement: the order within one is not fixed.
  writer->Add("y_rotate {:.3f} ", writer->Number(-180, 180));
  writer->Add("x_rotate {:.3f} ", writer->Number(-90, 90));
  const bool is_mirrored = writer->Below(4) == 0;
  writer->Add("scale {}{:.3f} 1.1 0.7 }} ", is_mirrored ? "-" : "", writer->Number(0.5, 1.5));
}

/// A node with an object and, below it, another.
void AddNodes(Writer* writer, uint32_t materials) {
  writer->Add("Node {{ ");
  AddTransform(writer);
  for (int depth = 0; depth < 2; ++depth) {
    if (depth == 1) {
      writer->Add("\nNode {{ ");
      AddTransform(writer);
    }
    writer->Add("Component<Material> {{ index {} }} ", writer->Below(materials));
    writer->Add("Component<Object> {{ ");
    AddObject(writer);
    writer->Add(" }} ");
  }
  writer->Add("}} }}\n");
}

/// A rectangle, a disk and a triangle that shine, in one node that is turned and stretched.
void AddFlatLamps(Writer* writer) {
  writer->Add("Node {{ ");
  AddTransform(writer);
  const char* shapes[] = {"rectangle width 1 height 0.6", "disk radius 0.5",
                          "triangle vertex0 0 0 0 vertex1 1 0 0 vertex2 0 1 0"};
  for (const char* shape : shapes) {
    writer->Add("\nNode {{ ");
    AddTransform(writer);
    writer->Add(
        "Component<Material> {{ index 0 }} Component<Object> {{ type {} }} "
        "Component<Light> {{ type area radiance 4 3 2 two_sided {} }} }}",
        shape, writer->Below(2) == 0 ? "true" : "false");
  }
  writer->Add(" }}\n");
}

/// Bodies that overlap, in glass that is clear or ground.
void AddDrink(Writer* writer, Paths paths) {
  const char* media[] = {"glass", "tea", "water"};
  for (uint32_t i = 0; i < 3; ++i) {
    writer->Add("Node {{ Transform {{ ");
    writer->AddVector("translate", -0.4, 0.4);
    writer->Add("}} Component<Object> {{ type sphere radius {:.3f} }} ", writer->Number(0.5, 1));
    writer->Add("Component<Material> {{ index 5 }} ");
    const uint32_t drawn = writer->Below(4);
    writer->Add("Component<Interior> {{ medium {} priority {} }} }}\n", media[i],
                paths == Paths::kFromLights ? 4 * i + drawn + 1 : drawn);
  }
}

void AddDirectionalLight(Writer* writer, const char* angle = "") {
  writer->Add("Node {{ Component<Light> {{ type directional ");
  writer->Add("direction {:.3f} -1 -0.7 ", writer->Number(-0.8, 0.8));
  writer->AddVector("color", 0.2, 0.9);
  writer->Add("{} }} }}\n", angle);
}

}  // namespace

std::string RandomScene(uint32_t seed) {
  Writer writer(seed);
  writer.Add("Background {{ ");
  writer.AddVector("color", 0, 0.5);
  writer.AddVector("ambient_light", 0, 0.2);
  writer.Add("}}\n");
  AddCamera(&writer);
  constexpr uint32_t kMaterials = 4;
  writer.Add("Materials {{\n");
  for (uint32_t i = 0; i < kMaterials; ++i) {
    writer.Add("Material {{ ");
    writer.AddVector("diffuse", 0.1, 0.9);
    if (i % 2 == 1) writer.AddVector("specular", 0.2, 0.8);
    writer.Add("shininess {:.3f} }}\n", writer.Number(0.5, 60));
  }
  writer.Add("}}\nScene {{\n");
  AddFloor(&writer);
  for (int i = 0; i < 6; ++i) AddNodes(&writer, kMaterials);
  AddDirectionalLight(&writer);
  writer.Add("Node {{ Transform {{ ");
  writer.AddVector("translate", 1, 4);
  writer.Add("}} Component<Light> {{ type point attenuation {:.3f} ", writer.Number(0.02, 0.2));
  writer.AddVector("color", 0.5, 1);
  writer.Add("}} }}\n}}\n");
  return writer.TakeText();
}

std::string RandomDistributionScene(uint32_t seed) {
  Writer writer(seed);
  const char* profiles[] = {"homogeneous", "exponential fog_height 2", "linear fog_height 5"};
  writer.Add("Background {{ fog {} fog_density 0.05 ", profiles[seed % 3]);
  writer.AddVector("fog_color", 0.2, 0.8);
  writer.AddVector("color", 0, 0.5);
  writer.AddVector("ambient_light", 0, 0.2);
  writer.Add("}}\n");
  AddCamera(&writer, "aperture 0.3 focus_distance 9");
  constexpr uint32_t kMaterials = 4;
  writer.Add("Materials {{\n");
  for (uint32_t i = 0; i < kMaterials; ++i) {
    writer.Add("Material {{ ");
    writer.AddVector("diffuse", 0.1, 0.9);
    if (i % 2 == 1) {
      writer.AddVector("specular", 0.2, 0.8);
      writer.Add("reflection_roughness {:.3f} ", writer.Number(0, 0.6));
    }
    if (i == 2) writer.Add("transmittance 0.9 0.8 0.9 ior 1.4 absorption 0.2 0 0.5 ");
    writer.Add("shininess {:.3f} }}\n", writer.Number(0.5, 60));
  }
  writer.Add("}}\nScene {{\n");
  AddFloor(&writer);
  for (int i = 0; i < 6; ++i) AddNodes(&writer, kMaterials);
  AddDirectionalLight(&writer);
  AddFlatLamps(&writer);
  writer.Add("}}\n");
  return writer.TakeText();
}

std::string RandomDiffuseScene(uint32_t seed, Paths paths) {
  Writer writer(seed);
  // Every kind of light and of surface that the path integrator knows, some in each scene.
  if (seed % 3 == 0) {
    writer.Add("Background {{ environment assets/environments/sky.hdr rotate {} }}\n", seed * 40);
  } else {
    writer.Add("Background {{ color 0.3 0.3 0.4 ambient_light 0 0 0 }}\n");
  }
  AddCamera(&writer, seed % 2 == 1 ? "aperture 0.3 focus_distance 9 blades 5" : "");
  constexpr uint32_t kMaterials = 11;
  writer.Add(
      "Textures {{ Texture {{ name board type checker even 0.2 0.7 0.9 odd 0.8 0.3 0.1 scale 5 5 "
      "rotation {} }}\n",
      seed * 7);
  writer.Add(
      "Texture {{ name tower type image file assets/cubemap/sky/front.png scale 2 3 }} }}\n"
      "Media {{ Medium {{ name tea ior 1.3 absorption 0.3 0.6 1 }} }}\n");
  writer.Add("Materials {{\n");
  for (uint32_t i = 0; i < 3; ++i) {
    writer.Add("Material {{ type diffuse ");
    writer.AddVector("albedo", 0.1, 0.9);
    writer.Add("}}\n");
  }
  writer.Add(
      "Material {{ type mirror }}\nMaterial {{ type conductor metal gold roughness 0.3 }}\n");
  writer.Add("Material {{ type dielectric ior 1.5 roughness {} }}\n", seed % 4 == 0 ? 0 : 0.4);
  writer.Add(
      "Material {{ name picture type diffuse albedo texture tower }}\n"
      "Material {{ name toy type plastic albedo texture board roughness 0.3 }}\n"
      "Material {{ name rusty type mix first picture second toy amount texture board }}\n"
      "Material {{ name net type mask material toy opacity texture board }}\n"
      "Material {{ name veil type mask material picture opacity 0.4 two_sided {} }}\n",
      seed % 2 == 0 ? "true" : "false");
  writer.Add("}}\nScene {{\n");
  if (paths == Paths::kFromCamera) {
    AddFloor(&writer);
  } else {
    writer.Add(
        "Node {{ Transform {{ translate 0 -2.5 0 x_rotate -85 }} Component<Material> {{ index 1 }} "
        "Component<Object> {{ type rectangle width 14 height 14 }} }}\n");
  }
  for (int i = 0; i < 6; ++i) AddNodes(&writer, kMaterials);
  AddDrink(&writer, paths);
  AddDirectionalLight(&writer, seed % 2 == 0 ? "angle 3" : "");
  AddFlatLamps(&writer);
  writer.Add(
      "Node {{ Transform {{ translate -2 4 2 }} Component<Light> {{ type spot direction 0.3 -1 "
      "-0.4 "
      "angle 50 attenuation 0.05 }} }}\n");
  writer.Add(
      "Node {{ Transform {{ translate 1 3 2 }} Component<Material> {{ index 0 }} "
      "Component<Object> {{ type sphere radius 0.6 }} "
      "Component<Light> {{ type area radiance 6 5 4 }} }}\n}}\n");
  return writer.TakeText();
}

}  // namespace candela::determinism
