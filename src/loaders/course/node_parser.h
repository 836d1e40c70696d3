#pragma once

#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "loaders/course/block_reader.h"
#include "loaders/course/scene_text.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// Reads the body of a `Scene` block: the tree of nodes, as a flat list with the root first.
class NodeParser {
 public:
  NodeParser(SceneText* tokens, BlockReader* blocks, Diagnostics* diagnostics)
      : tokens_(*tokens), blocks_(*blocks), diagnostics_(*diagnostics) {}

  std::vector<NodeSpec> Parse(const Token& scene);

 private:
  /// Reads what may stand in a node besides nodes.
  void ParseItem(const Token& word, NodeSpec* node);
  void ParseTransform(const Token& word, NodeSpec* node);
  void ParseKeyframes(const Token& word, NodeSpec* node);
  void ParseMaterial(const Token& word, NodeSpec* node);
  TypedSpec ParseTyped(const Token& word,
                       BlockReader::Textures textures = BlockReader::Textures::kNone);
  void WarnIfReplaced(bool is_replaced, const Token& word);
  void WarnOfSecond(std::string_view name, const Token& word);
  /// For what `word` opens, a place of the node.
  void TakePlace(const Token& word, NodeSpec* node);

  SceneText& tokens_;
  BlockReader& blocks_;
  Diagnostics& diagnostics_;
};

}  // namespace candela
