// apply_listings DOCUMENT OUT
//
// Does what a document tells its reader to do. A block "```cpp PATH" becomes the file OUT/PATH. A
// block "```diff PATH" changes a copy of PATH in OUT: each of its parts, between lines "@@", says
// with the marks of a diff what is there before and after. Run it in the root of the project.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <span>
#include <stdexcept>
#include <string>

#include "base/files.h"
#include "tests/docs/markdown.h"

namespace candela::docs {
namespace {

namespace fs = std::filesystem;

/// One part of a change: text that stands in the file once, and what takes its place.
struct Change {
  std::string before, after;
};

void Apply(const Change& change, std::string* text) {
  const size_t at = text->find(change.before);
  if (at == std::string::npos) throw std::runtime_error("not there: " + change.before);
  if (text->find(change.before, at + 1) != std::string::npos) {
    throw std::runtime_error("there more than once: " + change.before);
  }
  text->replace(at, change.before.size(), change.after);
}

void ApplyDiff(const std::string& diff, std::string* text) {
  Change change;
  for (size_t start = 0; start < diff.size();) {
    const size_t end = diff.find('\n', start) + 1;
    const std::string line = diff.substr(start, end - start);
    start = end;
    if (line == "@@\n") {
      Apply(change, text);
      change = {};
      continue;
    }
    if (line[0] != '+') change.before += line.substr(1);
    if (line[0] != '-') change.after += line.substr(1);
  }
  Apply(change, text);
}

void Write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  const auto written = WriteFileAtomically(path, std::as_bytes(std::span(text)));
  if (!written) throw std::runtime_error(path.string() + ": " + written.error().message);
}

void Run(const fs::path& document, const fs::path& out) {
  std::map<std::string, std::string> changed;  // A file may be changed in several places.
  for (const FencedBlock& block : FencedBlocks(ReadDocument(document))) {
    const std::string path = block.Argument();
    if (path.empty()) continue;
    if (block.Language() == "cpp") Write(out / path, block.text);
    if (block.Language() == "diff") {
      std::string& text = changed.try_emplace(path, ReadDocument(path)).first->second;
      ApplyDiff(block.text, &text);
      Write(out / path, text);
    }
  }
}

}  // namespace
}  // namespace candela::docs

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: apply_listings DOCUMENT OUT\n");
    return 2;
  }
  try {
    candela::docs::Run(argv[1], argv[2]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[1], error.what());
    return 1;
  }
}
