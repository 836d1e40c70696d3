#include "loaders/course/scene_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace candela {
namespace {

std::string ToText(Vec3 v) {
  return fmt::format("{} {} {}", v.x, v.y, v.z);
}

bool FitsFloat(const Mat4& matrix) {
  for (const auto& row : matrix.m) {
    for (const double value : row) {
      if (!std::isfinite(static_cast<float>(value))) return false;
    }
  }
  return true;
}

/// Writes blocks, each line as far to the right as there are blocks around it.
class Writer {
 public:
  explicit Writer(const SceneSpec& spec) : spec_(spec) {}

  std::string Write() {
    WriteSettings("Render", spec_.render);
    WriteSettings("Film", spec_.film);
    WriteCamera();
    WriteBackground();
    WriteList("Textures", spec_.textures,
              [this](const TextureSpec& each) { WriteTyped("Texture", each.name, each.texture); });
    WriteList("Materials", spec_.materials, [this](const MaterialSpec& each) {
      WriteTyped("Material", each.name, each.material);
    });
    WriteList("Media", spec_.media,
              [this](const MediumSpec& each) { WriteBlock("Medium", each.name, {}, each.params); });
    WriteNodes();
    return std::move(text_);
  }

 private:
  void Line(std::string_view line) {
    constexpr size_t kWidestIndent = 40;  // Nodes may be nested to any depth.
    text_ += std::string(std::min(depth_ * 2, kWidestIndent), ' ').append(line) + "\n";
  }

  void Open(std::string_view word) {
    Line(std::string(word) + " {");
    ++depth_;
  }
  void Close() {
    --depth_;
    Line("}");
  }

  std::string ToText(const Param& param) const {
    std::string text = param.name;
    for (const ParamWord& word : param.words) {
      text += " " + (param.is_path ? spec_.PathInScene(word) : word.text);
    }
    return text;
  }

  void WriteSettings(std::string_view word, const BlockSpec& block) {
    if (block.params.params.empty()) return;
    Open(word);
    for (const Param& param : block.params.params) Line(ToText(param));
    Close();
  }

  void WriteCamera() {
    Open("Camera");
    Line("type " + spec_.camera.type);
    for (const Param& param : spec_.camera.params.params) Line(ToText(param));
    Close();
  }

  void WriteBackground() {
    const BackgroundSpec& background = spec_.background;
    Open("Background");
    Line("color " + candela::ToText(background.color));
    Line("ambient_light " + candela::ToText(background.ambient_light));
    if (!background.cube_map.empty()) Line("cube_map " + background.cube_map);
    if (!background.environment.empty()) {
      Line("environment " + background.environment);
      Line(fmt::format("scale {}", background.environment_scale));
      Line(fmt::format("rotate {}", background.environment_rotate_degrees));
    }
    if (background.sky) WriteSky(*background.sky, background.environment_scale);
    if (background.fog) WriteFog(*background.fog);
    if (background.light_group.name != LightGroup::kDefault) {
      Line("group " + background.light_group.name);
    }
    Close();
  }

  void WriteSky(const SkySpec& sky, float scale) {
    Line("sky daylight");
    Line(fmt::format("scale {}", scale));
    Line(fmt::format("turbidity {}", sky.turbidity));
    Line(fmt::format("sun_elevation {}", sky.sun_elevation_degrees));
    Line(fmt::format("sun_azimuth {}", sky.sun_azimuth_degrees));
    Line("ground_albedo " + candela::ToText(sky.ground_albedo));
    Line(fmt::format("sun {}", sky.has_sun));
  }

  void WriteFog(const FogSpec& fog) {
    Line(fmt::format("fog {}", FogSpec::kProfileWords[static_cast<size_t>(fog.profile)]));
    Line("fog_color " + candela::ToText(fog.color));
    Line(fmt::format("fog_density {}", fog.density));
    if (fog.profile == FogSpec::Profile::kHomogeneous) return;
    Line(fmt::format("fog_base {}", fog.base));
    Line(fmt::format("fog_height {}", fog.height));
  }

  template <class Spec, class WriteOne>
  void WriteList(std::string_view word, const std::vector<Spec>& list, const WriteOne& write_one) {
    if (list.empty()) return;
    Open(word);
    for (const Spec& each : list) write_one(each);
    Close();
  }

  void WriteTyped(std::string_view word, const std::string& name, const TypedSpec& spec) {
    WriteBlock(word, name, spec.type, spec.params);
  }

  /// In one line; a name or a type that is empty is left out.
  void WriteBlock(std::string_view word, const std::string& name, const std::string& type,
                  const ParamSet& params) {
    std::string items;
    const auto add = [&](const std::string& item) { items += (items.empty() ? " " : "  ") + item; };
    if (!name.empty()) add("name " + name);
    if (!type.empty()) add("type " + type);
    for (const Param& param : params.params) add(ToText(param));
    Line(std::string(word) + " {" + items + " }");
  }

  /// The nodes are in the order of a file, each after its parent: those that are open when one
  /// begins and are not around it end there.
  void WriteNodes() {
    std::vector<uint32_t> open;
    for (uint32_t i = 0; i < spec_.nodes.size(); ++i) {
      const NodeSpec& node = spec_.nodes[i];
      for (; !open.empty() && open.back() != node.parent; open.pop_back()) Close();
      Open(open.empty() ? "Scene" : "Node");
      open.push_back(i);
      WriteItems(node);
    }
    for (; !open.empty(); open.pop_back()) Close();
  }

  /// The numbers of a scene have the range of single precision, those of a product do not: what
  /// they go beyond it becomes factors in front, as many as it takes to leave double precision as
  /// well where the product has.
  void WriteTransform(Mat4 matrix) {
    constexpr double kFactor = 0x1p120;  // A power of two: it changes no digit.
    constexpr int kTooMany = 10;
    int factors = 0;
    for (; factors < kTooMany && !FitsFloat(matrix); ++factors) {
      matrix = Mat4::Scale({1 / kFactor, 1 / kFactor, 1 / kFactor}) * matrix;
    }
    if (factors == kTooMany) matrix = Mat4::Identity();
    std::string steps;
    for (; factors > 0; --factors) steps += fmt::format("scale {0} {0} {0}  ", kFactor);
    steps += "matrix";
    for (size_t row = 0; row < 3; ++row) {
      steps += fmt::format("  {}", fmt::join(matrix.m[row], " "));
    }
    Line("Transform { " + steps + " }");
  }

  void WriteItems(const NodeSpec& node) {
    if (!node.motion.empty()) {
      Open("Keyframes");
      for (const Mat4& matrix : node.motion) WriteTransform(matrix);
      Close();
    } else if (node.parent_from_node != Mat4::Identity()) {
      WriteTransform(node.parent_from_node);
    }
    if (node.material && !node.material->name.empty()) {
      Line("Component<Material> { name " + node.material->name + " }");
    } else if (node.material && node.material->index) {
      Line(fmt::format("Component<Material> {{ index {} }}", *node.material->index));
    }
    if (node.object) WriteTyped("Component<Object>", {}, *node.object);
    if (node.interior) WriteBlock("Component<Interior>", {}, {}, node.interior->params);
    if (node.light) WriteTyped("Component<Light>", {}, *node.light);
  }

  const SceneSpec& spec_;
  std::string text_;
  size_t depth_ = 0;
};

}  // namespace

std::string WriteScene(const SceneSpec& spec) {
  return Writer(spec).Write();
}

}  // namespace candela
