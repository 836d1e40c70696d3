#include "loaders/course/node_parser.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>

#include "base/number.h"
#include "base/text.h"
#include "scene_spec/param_reader.h"

namespace candela {
namespace {

constexpr std::string_view kNodeWords[] = {"Node", "Transform", "Component<Material>",
                                           "Component<Light>", "Component<Object>"};
constexpr std::string_view kTransformWords[] = {"translate", "scale", "x_rotate", "y_rotate",
                                                "z_rotate"};

/// The numbers of a transform step, or nothing when they are not exactly `count` numbers.
std::optional<std::array<double, 3>> Numbers(const Param& param, size_t count) {
  std::array<double, 3> numbers{};
  if (param.words.size() != count) return std::nullopt;
  for (size_t i = 0; i < count; ++i) {
    const auto value = ParseDouble(param.words[i].text);
    if (!value) return std::nullopt;
    numbers[i] = *value;
  }
  return numbers;
}

/// The matrix of one step, or nothing when its numbers are wrong, which is reported.
std::optional<Mat4> StepMatrix(const Param& step, Diagnostics* diagnostics) {
  const std::string_view name = step.name;
  if (name == "translate" || name == "scale") {
    if (const auto n = Numbers(step, 3)) {
      const Vec3d v{(*n)[0], (*n)[1], (*n)[2]};
      return name == "scale" ? Mat4::Scale(v) : Mat4::Translate(v);
    }
  } else {
    if (const auto n = Numbers(step, 1)) return Mat4::Rotate(name[0] - 'x', (*n)[0]);
  }
  // The reader of ordinary parameters says what is wrong with the numbers.
  const ParamSet only{{step}};
  ParamReader reader(only, "Transform", step.where, diagnostics);
  name == "translate" || name == "scale" ? static_cast<void>(reader.Vector(name, {}))
                                         : static_cast<void>(reader.Number(name, 0));
  return std::nullopt;
}

}  // namespace

TypedSpec TakeType(ParamSet params, const SourceLocation& where, std::string_view block,
                   std::string_view default_type, Diagnostics* diagnostics) {
  TypedSpec spec{std::string(default_type), where, {}};
  ParamReader reader(params, block, where, diagnostics);
  if (reader.Has("type") || default_type.empty()) {
    spec.type = reader.RequiredWord("type");
    spec.where = reader.Where("type");
  }
  for (Param& param : params.params) {
    if (param.name != "type") spec.params.params.push_back(std::move(param));
  }
  return spec;
}

std::vector<NodeSpec> NodeParser::Parse(const Token& scene) {
  blocks_.OpenBlock(scene);
  std::vector<NodeSpec> nodes(1);
  // The open nodes, innermost last: a list of our own, since files may nest deeper than a stack.
  struct OpenNode {
    uint32_t index;
    Token opener;
  };
  std::vector<OpenNode> open = {{0, scene}};
  while (!open.empty()) {
    const Token token = tokens_.Next();
    const uint32_t current = open.back().index;
    if (token.kind == Token::Kind::kCloseBrace) {
      open.pop_back();
    } else if (token.IsEnd()) {
      blocks_.UnexpectedEnd(open.back().opener);
      return nodes;
    } else if (token.text == "Node") {
      blocks_.OpenBlock(token);
      open.push_back({static_cast<uint32_t>(nodes.size()), token});
      nodes.emplace_back().parent = current;
    } else if (!ParseItem(token, &nodes[current])) {
      blocks_.UnknownWord(token, kNodeWords);
      if (diagnostics_.IsFull(tokens_.Where(token))) return nodes;
    }
  }
  return nodes;
}

bool NodeParser::ParseItem(const Token& word, NodeSpec* node) {
  if (word.text == "Transform") {
    ParseTransform(word, node);
  } else if (word.text == "Component<Material>") {
    ParseMaterial(word, node);
  } else if (word.text == "Component<Light>") {
    WarnIfReplaced(node->light.has_value(), word);
    node->light = ParseTyped(word);
  } else if (word.text == "Component<Object>") {
    WarnIfReplaced(node->object.has_value(), word);
    node->object = ParseTyped(word);
  } else {
    return false;
  }
  return true;
}

void NodeParser::WarnIfReplaced(bool is_replaced, const Token& word) {
  if (!is_replaced) return;
  diagnostics_.Warning(
      tokens_.Where(word),
      fmt::format("this node already has a {}; the last one counts", Quote(word.text)));
}

void NodeParser::ParseTransform(const Token& word, NodeSpec* node) {
  WarnIfReplaced(node->transform_where.line != 0, word);
  node->transform_where = tokens_.Where(word);
  node->parent_from_node = Mat4::Identity();

  blocks_.OpenBlock(word);
  for (const Param& step : blocks_.ReadParams(word).params) {
    bool is_known = false;
    for (const std::string_view name : kTransformWords) is_known = is_known || step.name == name;
    if (!is_known) {
      diagnostics_.Error(step.where,
                         fmt::format("{} is due, found {}{}", ListOf(kTransformWords),
                                     Quote(step.name), DidYouMean(step.name, kTransformWords)));
      continue;
    }
    // Each further step acts on the object before the ones written so far.
    if (const auto matrix = StepMatrix(step, &diagnostics_)) {
      node->parent_from_node = node->parent_from_node * *matrix;
    }
  }
}

void NodeParser::ParseMaterial(const Token& word, NodeSpec* node) {
  WarnIfReplaced(node->material.has_value(), word);
  blocks_.OpenBlock(word);
  const ParamSet params = blocks_.ReadParams(word);
  const SourceLocation where = tokens_.Where(word);
  ParamReader reader(params, word.text, where, &diagnostics_);
  MaterialReference reference;
  if (reader.Has("name")) {
    reference.name = reader.RequiredWord("name");
    reference.where = reader.Where("name");
    if (reader.Has("index"))
      reader.Error(where, "a material is chosen by 'index' or by 'name', not by both");
  } else {
    reference.index = reader.RequiredInteger("index");
    reference.where = reader.Where("index");
  }
  reader.Finish();
  node->material = std::move(reference);
}

TypedSpec NodeParser::ParseTyped(const Token& word) {
  blocks_.OpenBlock(word);
  return TakeType(blocks_.ReadParams(word), tokens_.Where(word), word.text, "", &diagnostics_);
}

}  // namespace candela
