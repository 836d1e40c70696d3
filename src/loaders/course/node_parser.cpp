#include "loaders/course/node_parser.h"

#include <fmt/format.h>

#include <utility>

#include "base/text.h"
#include "loaders/course/block_words.h"
#include "loaders/course/transform_steps.h"
#include "loaders/course/typed_block.h"
#include "scene_spec/param_reader.h"

namespace candela {

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
    const Token token = blocks_.NextItem(&open.back().opener, kNodeWords);
    const uint32_t current = open.back().index;
    if (token.IsEnd()) return nodes;
    if (token.IsCloseBrace()) {
      open.pop_back();
    } else if (token.text == "Node") {
      blocks_.OpenBlock(token);
      open.push_back({static_cast<uint32_t>(nodes.size()), token});
      nodes.emplace_back().parent = current;
    } else {
      ParseItem(token, &nodes[current]);
    }
  }
  return nodes;
}

void NodeParser::ParseItem(const Token& word, NodeSpec* node) {
  if (word.text == "Transform") {
    ParseTransform(word, node);
  } else if (word.text == "Keyframes") {
    ParseKeyframes(word, node);
  } else if (word.text == "Component<Material>") {
    ParseMaterial(word, node);
  } else if (word.text == "Component<Interior>") {
    WarnIfReplaced(node->interior.has_value(), word);
    const SourceLocation where = tokens_.Where(word);
    node->interior = InteriorSpec{blocks_.ReadParams(word), where};
  } else if (word.text == "Component<Light>") {
    WarnIfReplaced(node->light.has_value(), word);
    node->light = ParseTyped(word, BlockReader::Textures::kByName);
  } else {
    WarnIfReplaced(node->object.has_value(), word);
    node->object = ParseTyped(word);
  }
}

void NodeParser::WarnIfReplaced(bool is_replaced, const Token& word) {
  if (is_replaced) WarnOfSecond(word.text, word);
}

void NodeParser::WarnOfSecond(std::string_view name, const Token& word) {
  diagnostics_.Warning(tokens_.Where(word),
                       fmt::format("this node already has a {}; the last one counts", Quote(name)));
}

void NodeParser::TakePlace(const Token& word, NodeSpec* node) {
  if (node->transform_where.line != 0) {
    WarnOfSecond(node->motion.empty() ? "Transform" : "Keyframes", word);
  }
  node->transform_where = tokens_.Where(word);
  node->motion.clear();
}

void NodeParser::ParseTransform(const Token& word, NodeSpec* node) {
  TakePlace(word, node);
  const ParamSet steps = blocks_.ReadParams(word, BlockReader::Repeats::kLegal);
  node->parent_from_node = Product(ReadSteps(steps, &diagnostics_));
}

void NodeParser::ParseKeyframes(const Token& word, NodeSpec* node) {
  TakePlace(word, node);
  const size_t errors_before = diagnostics_.ErrorCount();
  blocks_.OpenBlock(word);
  std::vector<TransformSteps> frames;
  for (Token frame = blocks_.NextItem(&word, kKeyframesWords); frame.IsWord();
       frame = blocks_.NextItem(&word, kKeyframesWords)) {
    frames.push_back(
        ReadSteps(blocks_.ReadParams(frame, BlockReader::Repeats::kLegal), &diagnostics_));
  }
  node->motion.assign(2, Mat4::Identity());
  if (diagnostics_.ErrorCount() > errors_before) return;
  if (frames.size() < 2) {
    diagnostics_.Error(tokens_.Where(word),
                       fmt::format("'Keyframes' needs a 'Transform' for the begin, one for the end "
                                   "and any number in between, found {}",
                                   frames.size()));
    return;
  }
  const size_t parts = PartsOfKeyframes(frames);
  if (parts * (frames.size() - 1) >= NodeSpec::kMostSteps) {
    diagnostics_.Error(
        tokens_.Where(word),
        fmt::format("the keyframes make more steps than the {} that are possible, with one for "
                    "each {} degrees of a turn",
                    NodeSpec::kMostSteps, kDegreesOfPart));
    return;
  }
  node->motion = MatricesOfKeyframes(frames, parts);
}

void NodeParser::ParseMaterial(const Token& word, NodeSpec* node) {
  WarnIfReplaced(node->material.has_value(), word);
  const ParamSet params = blocks_.ReadParams(word);
  const SourceLocation where = tokens_.Where(word);
  ParamReader reader(params, word.text, where, &diagnostics_);
  MaterialReference reference;
  if (reader.Has("name")) {
    reference.name = reader.RequiredWord("name");
    reference.where = reader.Where("name");
    if (reader.Has("index")) {
      reader.Error(reader.Where("index"),
                   "a material is chosen by 'index' or by 'name', not by both");
    }
  } else {
    reference.index = reader.RequiredInteger("index");
    reference.where = reader.Where("index");
  }
  reader.Finish();
  node->material = std::move(reference);
}

TypedSpec NodeParser::ParseTyped(const Token& word, BlockReader::Textures textures) {
  return TakeType(blocks_.ReadParams(word, BlockReader::Repeats::kOdd, textures),
                  tokens_.Where(word), word.text, "", &diagnostics_);
}

}  // namespace candela
