#include "loaders/course/scene_parser.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "base/files.h"
#include "base/text.h"
#include "loaders/course/block_reader.h"
#include "loaders/course/node_parser.h"
#include "loaders/obj/obj_reader.h"
#include "loaders/text/nul_check.h"
#include "loaders/text/tokenizer.h"
#include "scene_spec/param_reader.h"

namespace candela {
namespace {

constexpr std::string_view kSectionWords[] = {"Background", "Camera", "Materials", "Scene"};
constexpr std::string_view kMaterialWords[] = {"Material"};

/// Parameters of sections that may be given in parts: a later value replaces an earlier one.
struct Section {
  ParamSet params;
  SourceLocation where;
  bool is_given = false;
};

class Parser {
 public:
  Parser(std::shared_ptr<const std::string> file, std::string_view text,
         const std::filesystem::path& folder, Diagnostics* diagnostics)
      : tokens_(file, text), blocks_(&tokens_, diagnostics), diagnostics_(*diagnostics) {
    scene_.file.file = std::move(file);
    scene_.folder = folder;
  }

  SceneSpec Parse() {
    while (!tokens_.Peek().IsEnd() && !diagnostics_.IsFull(scene_.file)) ParseSection();
    ReadCamera();
    ReadBackground();
    if (scene_.nodes.empty()) diagnostics_.Error(scene_.file, "there is no 'Scene' block");
    LoadMeshes();
    return std::move(scene_);
  }

 private:
  void ParseSection() {
    const Token word = tokens_.Next();
    if (word.kind == Token::Kind::kCloseBrace) {
      diagnostics_.Warning(tokens_.Where(word), "this closing brace closes nothing");
    } else if (word.text == "Camera") {
      ParseParams(word, &camera_);
    } else if (word.text == "Background") {
      ParseParams(word, &background_);
    } else if (word.text == "Materials") {
      WarnIfRepeated(have_materials_, word);
      have_materials_ = true;
      ParseMaterials(word);
    } else if (word.text == "Scene") {
      WarnIfRepeated(!scene_.nodes.empty(), word);
      scene_.nodes = NodeParser(&tokens_, &blocks_, &diagnostics_).Parse(word);
    } else {
      blocks_.UnknownWord(word, kSectionWords);
    }
  }

  void WarnIfRepeated(bool is_repeated, const Token& word) {
    if (!is_repeated) return;
    diagnostics_.Warning(tokens_.Where(word),
                         fmt::format("a second block {}; the last one counts", Quote(word.text)));
  }

  void ParseParams(const Token& word, Section* section) {
    WarnIfRepeated(section->is_given, word);
    section->is_given = true;
    section->where = tokens_.Where(word);
    blocks_.OpenBlock(word);
    for (Param& param : blocks_.ReadParams(word).params) {
      section->params.params.push_back(std::move(param));
    }
  }

  void ParseMaterials(const Token& opener) {
    scene_.materials.clear();
    blocks_.OpenBlock(opener);
    while (true) {
      const Token word = tokens_.Next();
      if (word.kind == Token::Kind::kCloseBrace) return;
      if (word.IsEnd()) return blocks_.UnexpectedEnd(opener);
      if (word.text == "Material") {
        ParseMaterial(word);
      } else {
        blocks_.UnknownWord(word, kMaterialWords);
        if (diagnostics_.IsFull(scene_.file)) return;
      }
    }
  }

  void ParseMaterial(const Token& word) {
    blocks_.OpenBlock(word);
    const SourceLocation where = tokens_.Where(word);
    ParamSet params = blocks_.ReadParams(word);
    MaterialSpec material;
    if (params.Find("name")) {
      ParamReader reader(params, word.text, where, &diagnostics_);
      material.name = reader.RequiredWord("name");
      const SourceLocation name_where = reader.Where("name");
      for (const MaterialSpec& other : scene_.materials) {
        if (!material.name.empty() && other.name == material.name) {
          diagnostics_.Error(name_where,
                             fmt::format("a material named {} stands in line {} already",
                                         Quote(material.name), other.material.where.line));
        }
      }
      std::erase_if(params.params, [](const Param& param) { return param.name == "name"; });
    }
    material.material = TakeType(std::move(params), where, word.text, "phong", &diagnostics_);
    scene_.materials.push_back(std::move(material));
  }

  void ReadCamera() {
    if (!camera_.is_given) {
      diagnostics_.Error(scene_.file, "there is no 'Camera' block");
      return;
    }
    ParamReader reader(camera_.params, "Camera", camera_.where, &diagnostics_);
    CameraSpec& camera = scene_.camera;
    camera.center = reader.RequiredVector("center");
    camera.direction = reader.RequiredDirection("direction");
    camera.up = reader.RequiredDirection("up");
    camera.fov_degrees = reader.RequiredAngle("fov");
    const Vec3d direction = Normalize(ToDouble(camera.direction));
    const Vec3d up = Normalize(ToDouble(camera.up));
    const bool have_both = reader.Has("direction") && reader.Has("up");
    if (have_both && Length(Cross(direction, up)) < 1e-7) {
      reader.Error(reader.Where("up"), "'up' is parallel to 'direction'");
    }
    reader.Finish();
  }

  void ReadBackground() {
    ParamReader reader(background_.params, "Background", background_.where, &diagnostics_);
    BackgroundSpec& background = scene_.background;
    background.color = reader.Color("color", {0, 0, 0});
    background.ambient_light = reader.Color("ambient_light", {0, 0, 0});
    background.cube_map = reader.Word("cube_map");
    background.cube_map_where = reader.Where("cube_map");
    reader.Finish();
  }

  void LoadMeshes() {
    for (const NodeSpec& node : scene_.nodes) {
      if (!node.object || node.object->type != "mesh") continue;
      const Param* path = node.object->params.Find("obj_file");
      if (!path || path->words.size() != 1) continue;  // Reported when the mesh is compiled.
      const std::string& name = path->words[0].text;
      if (scene_.meshes.contains(name)) continue;
      scene_.meshes[name] = LoadObj(scene_.folder / name, path->words[0].where, &diagnostics_);
    }
  }

  Tokenizer tokens_;
  BlockReader blocks_;
  Diagnostics& diagnostics_;
  SceneSpec scene_;
  Section camera_, background_;
  bool have_materials_ = false;
};

}  // namespace

SceneSpec ParseScene(std::shared_ptr<const std::string> file, std::string_view text,
                     const std::filesystem::path& folder, Diagnostics* diagnostics) {
  if (HasNul(file, text, diagnostics)) return {};
  return Parser(std::move(file), text, folder, diagnostics).Parse();
}

SceneSpec LoadScene(const std::filesystem::path& path, Diagnostics* diagnostics) {
  const auto file = std::make_shared<const std::string>(path.string());
  const Result<std::string> text = ReadFile(path);
  if (!text) {
    diagnostics->Error({file, 0, 0}, text.error().message);
    return {};
  }
  return ParseScene(file, *text, path.parent_path(), diagnostics);
}

}  // namespace candela
