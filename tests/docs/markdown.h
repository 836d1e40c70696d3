#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace candela::docs {

/// A fenced block of a document: what stands between two lines of three backticks.
struct FencedBlock {
  std::string info;  ///< What follows the opening backticks: "scene", "cpp src/shapes/disk.h".
  std::string text;
  int line = 0;  ///< Of the opening backticks, from 1.

  /// The first word of `info`, and what follows it.
  std::string Language() const;
  std::string Argument() const;
};

/// The fenced blocks in their order. Throws when a block does not end.
std::vector<FencedBlock> FencedBlocks(std::string_view markdown);

/// A link to a file or to a heading of this project, as written: "testing.md#labels".
struct Link {
  std::string target;
  int line = 0;
};

/// All links and pictures outside code that do not lead to another host.
std::vector<Link> LocalLinks(std::string_view markdown);

/// The anchors of all headings, as GitHub makes them: lower case, dashes for blanks, no
/// punctuation.
std::vector<std::string> Anchors(std::string_view markdown);

/// The content of a file of this project. Throws when it cannot be read.
std::string ReadDocument(const std::filesystem::path& path);

}  // namespace candela::docs
