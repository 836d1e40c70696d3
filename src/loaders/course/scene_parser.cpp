#include "loaders/course/scene_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "base/files.h"
#include "base/text.h"
#include "loaders/course/block_reader.h"
#include "loaders/course/block_words.h"
#include "loaders/course/load_meshes.h"
#include "loaders/course/node_parser.h"
#include "loaders/course/read_fog.h"
#include "loaders/course/read_sky.h"
#include "loaders/course/scene_text.h"
#include "loaders/course/typed_block.h"
#include "loaders/text/nul_check.h"
#include "scene_spec/param_reader.h"

namespace candela {
namespace {

class Parser {
 public:
  Parser(std::shared_ptr<const std::string> file, std::string_view text,
         const std::filesystem::path& folder, Diagnostics* diagnostics)
      : tokens_(file, text, folder, diagnostics),
        blocks_(&tokens_, diagnostics),
        diagnostics_(*diagnostics) {
    scene_.file.file = std::move(file);
    scene_.folder = folder;
  }

  SceneSpec Parse() {
    for (Token word = NextSection(); !word.IsEnd(); word = NextSection()) ParseSection(word);
    scene_.files = tokens_.included();
    // Materials that nobody can find may be what was not understood.
    if (!have_materials_ && diagnostics_.HasErrors()) scene_.materials_are_damaged = true;
    if (!have_textures_ && diagnostics_.HasErrors()) scene_.textures_are_damaged = true;
    if (!have_media_ && diagnostics_.HasErrors()) scene_.media_are_damaged = true;
    CheckNames(scene_.materials, "material");
    CheckNames(scene_.textures, "texture");
    CheckNames(scene_.media, "medium");
    ReadCamera();
    ReadBackground();
    if (scene_.nodes.empty() && !blocks_.HasLostSections()) {
      diagnostics_.Error(scene_.file, "there is no 'Scene' block");
    }
    LoadMeshes(&scene_, &diagnostics_);
    return std::move(scene_);
  }

 private:
  Token NextSection() { return blocks_.NextItem(nullptr, kSectionWords); }

  void ParseSection(const Token& word) {
    if (word.IsCloseBrace()) {
      diagnostics_.Warning(tokens_.Where(word), "this closing brace closes nothing");
    } else if (word.text == "Camera") {
      ParseParams(word, &camera_);
    } else if (word.text == "Background") {
      ParseParams(word, &background_);
    } else if (word.text == "Render") {
      ParseParams(word, &scene_.render);
    } else if (word.text == "Film") {
      ParseParams(word, &scene_.film);
    } else if (word.text == "Materials") {
      WarnIfRepeated(have_materials_, word);
      have_materials_ = true;
      ParseList(word, kMaterialsWords, &Parser::ParseMaterial, &scene_.materials,
                &scene_.materials_are_damaged);
    } else if (word.text == "Media") {
      WarnIfRepeated(have_media_, word);
      have_media_ = true;
      ParseList(word, kMediaWords, &Parser::ParseMedium, &scene_.media, &scene_.media_are_damaged);
    } else if (word.text == "Textures") {
      WarnIfRepeated(have_textures_, word);
      have_textures_ = true;
      ParseList(word, kTexturesWords, &Parser::ParseTexture, &scene_.textures,
                &scene_.textures_are_damaged);
    } else {
      WarnIfRepeated(!scene_.nodes.empty(), word);
      scene_.nodes = NodeParser(&tokens_, &blocks_, &diagnostics_).Parse(word);
    }
  }

  void WarnIfRepeated(bool is_repeated, const Token& word) {
    if (!is_repeated) return;
    diagnostics_.Warning(tokens_.Where(word),
                         fmt::format("a second block {}; the last one counts", Quote(word.text)));
  }

  /// Blocks of one section add to each other: a later value replaces an earlier one.
  void ParseParams(const Token& word, BlockSpec* section) {
    WarnIfRepeated(section->is_given, word);
    section->is_given = true;
    section->where = tokens_.Where(word);
    ParamSet block = blocks_.ReadParams(word);
    std::move(block.params.begin(), block.params.end(), std::back_inserter(section->params.params));
    section->params.is_damaged |= block.is_damaged;
  }

  /// The blocks of a list, each read by `parse`, in the place of an earlier list.
  template <class NamedSpec>
  void ParseList(const Token& opener, std::span<const std::string_view> words,
                 NamedSpec (Parser::*parse)(const Token& word), std::vector<NamedSpec>* list,
                 bool* are_damaged) {
    list->clear();
    const size_t errors_before = diagnostics_.ErrorCount();
    blocks_.OpenBlock(opener);
    for (Token word = blocks_.NextItem(&opener, words); word.IsWord();
         word = blocks_.NextItem(&opener, words)) {
      list->push_back((this->*parse)(word));
    }
    *are_damaged = diagnostics_.ErrorCount() > errors_before;
  }

  MaterialSpec ParseMaterial(const Token& word) {
    const SourceLocation where = tokens_.Where(word);
    ParamSet params = ReadNamedBlock(word);
    MaterialSpec material;
    TakeName(where, word, &params, &material);
    material.material = TakeType(std::move(params), where, word.text, "phong", &diagnostics_);
    return material;
  }

  TextureSpec ParseTexture(const Token& word) {
    const SourceLocation where = tokens_.Where(word);
    ParamSet params = ReadNamedBlock(word);
    TextureSpec texture;
    TakeName(where, word, &params, &texture);
    if (texture.name.empty() && !params.is_damaged) {
      diagnostics_.Error(where, "'Texture' needs 'name'");
    }
    texture.texture = TakeType(std::move(params), where, word.text, "", &diagnostics_);
    return texture;
  }

  MediumSpec ParseMedium(const Token& word) {
    MediumSpec medium;
    medium.where = tokens_.Where(word);
    medium.params = blocks_.ReadParams(word);
    TakeName(medium.where, word, &medium.params, &medium);
    if (medium.name.empty() && !medium.params.is_damaged) {
      diagnostics_.Error(medium.where, "'Medium' needs 'name'");
    }
    return medium;
  }

  ParamSet ReadNamedBlock(const Token& word) {
    return blocks_.ReadParams(word, BlockReader::Repeats::kOdd, BlockReader::Textures::kByName);
  }

  /// Moves the name of a block out of its parameters.
  template <class NamedSpec>
  void TakeName(const SourceLocation& where, const Token& word, ParamSet* params,
                NamedSpec* named) {
    ParamReader reader(*params, word.text, where, &diagnostics_);
    if (!reader.Has("name")) return;
    named->name = reader.Word("name");
    named->name_where = reader.Where("name");
    std::erase_if(params->params, [](const Param& param) { return param.name == "name"; });
  }

  template <class NamedSpec>
  void CheckNames(const std::vector<NamedSpec>& list, std::string_view kind) {
    std::map<std::string_view, const NamedSpec*> by_name;
    for (const NamedSpec& each : list) {
      if (each.name.empty()) continue;
      const NamedSpec* first = by_name.try_emplace(each.name, &each).first->second;
      if (first == &each) continue;
      diagnostics_.Error(each.name_where, [&] {
        const bool is_beside = first->name_where.file == each.name_where.file;
        return fmt::format("a {} named {} stands in {} already", kind, Quote(each.name),
                           is_beside ? fmt::format("line {}", first->name_where.line)
                                     : ToString(first->name_where));
      });
    }
  }

  void ReadCamera() {
    if (!camera_.is_given) {
      if (!blocks_.HasLostSections()) diagnostics_.Error(scene_.file, "there is no 'Camera' block");
      return;
    }
    scene_.camera =
        TakeType(std::move(camera_.params), camera_.where, "Camera", "perspective", &diagnostics_);
  }

  void ReadBackground() {
    ParamReader reader(background_.params, "Background", background_.where, &diagnostics_);
    BackgroundSpec& background = scene_.background;
    background.color = reader.Color("color", {0, 0, 0});
    background.ambient_light = reader.Color("ambient_light", {0, 0, 0});
    background.cube_map = scene_.PathInScene(reader.Path("cube_map"));
    background.cube_map_where = reader.Where("cube_map");
    background.sky = ReadSky(&reader);
    ReadEnvironment(&reader);
    background.fog = ReadFog(&reader);
    background.light_group = ReadLightGroup(&reader);
    reader.Finish();
  }

  void ReadEnvironment(ParamReader* reader) {
    BackgroundSpec& background = scene_.background;
    background.environment = scene_.PathInScene(reader->Path("environment"));
    background.environment_where = reader->Where("environment");
    background.environment_scale = reader->NonNegative("scale", 1);
    background.environment_rotate_degrees = reader->Number("rotate", 0);
    if (!reader->Has("environment")) {
      for (const std::string_view name : {"scale", "rotate"}) {
        if (!reader->Has(name) || (name == "scale" && background.sky)) continue;
        reader->Error(reader->Where(name),
                      fmt::format("'{}' is for an 'environment'{}, of which there is none", name,
                                  name == "scale" ? " or a 'sky'" : ""));
      }
    } else if (reader->Has("cube_map")) {
      reader->Error(background.environment_where,
                    "a background has a 'cube_map' or an 'environment', not both");
    }
  }

  SceneText tokens_;
  BlockReader blocks_;
  Diagnostics& diagnostics_;
  SceneSpec scene_;
  BlockSpec camera_, background_;
  bool have_materials_ = false, have_textures_ = false, have_media_ = false;
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
    diagnostics->Error({file, 0, 0}, text.error().message, text.error().code);
    return {};
  }
  SceneSpec scene = ParseScene(file, *text, path.parent_path(), diagnostics);
  scene.files.insert(scene.files.begin(), path);
  return scene;
}

}  // namespace candela
