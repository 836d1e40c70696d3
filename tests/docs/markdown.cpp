#include "tests/docs/markdown.h"

#include <cctype>
#include <regex>
#include <stdexcept>

#include "base/files.h"

namespace candela::docs {
namespace {

constexpr std::string_view kFence = "```";

std::vector<std::string> LinesOf(std::string_view text) {
  std::vector<std::string> lines;
  for (size_t start = 0; start < text.size();) {
    const size_t end = std::min(text.find('\n', start), text.size());
    lines.emplace_back(text.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

/// The lines with those of fenced blocks, and what stands between single backticks, made empty.
std::vector<std::string> LinesOfProse(std::string_view markdown) {
  static const std::regex kCode("`[^`]*`");
  std::vector<std::string> lines = LinesOf(markdown);
  bool is_code = false;
  for (std::string& line : lines) {
    const bool is_fence = line.starts_with(kFence);
    if (is_fence) is_code = !is_code;
    line = is_code || is_fence ? std::string() : std::regex_replace(line, kCode, "``");
  }
  return lines;
}

std::string AnchorOf(std::string_view heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '_' || c == '-') {
      anchor += static_cast<char>(std::tolower(byte));
    }
    if (c == ' ') anchor += '-';
  }
  return anchor;
}

}  // namespace

std::string FencedBlock::Language() const {
  return info.substr(0, info.find(' '));
}

std::string FencedBlock::Argument() const {
  const size_t blank = info.find(' ');
  return blank == std::string::npos ? std::string() : info.substr(blank + 1);
}

std::vector<FencedBlock> FencedBlocks(std::string_view markdown) {
  std::vector<FencedBlock> blocks;
  bool is_open = false;
  int number = 0;
  for (const std::string& line : LinesOf(markdown)) {
    ++number;
    if (line.starts_with(kFence)) {
      if (!is_open) blocks.push_back({line.substr(kFence.size()), {}, number});
      is_open = !is_open;
    } else if (is_open) {
      blocks.back().text += line + "\n";
    }
  }
  if (is_open) throw std::runtime_error("a fenced block does not end: " + blocks.back().info);
  return blocks;
}

std::vector<Link> LocalLinks(std::string_view markdown) {
  static const std::regex kLink(R"(\]\(([^)\s]+)\))");
  std::vector<Link> links;
  int number = 0;
  for (const std::string& line : LinesOfProse(markdown)) {
    ++number;
    for (std::sregex_iterator match(line.begin(), line.end(), kLink), end; match != end; ++match) {
      const std::string target = (*match)[1];
      if (target.find("://") == std::string::npos) links.push_back({target, number});
    }
  }
  return links;
}

std::vector<std::string> Anchors(std::string_view markdown) {
  std::vector<std::string> anchors;
  bool is_code = false;
  for (const std::string& line : LinesOf(markdown)) {
    if (line.starts_with(kFence)) is_code = !is_code;
    const size_t marks = line.find_first_not_of('#');
    if (is_code || marks == 0 || marks == std::string::npos || line[marks] != ' ') continue;
    anchors.push_back(AnchorOf(std::string_view(line).substr(marks + 1)));
  }
  return anchors;
}

std::string ReadDocument(const std::filesystem::path& path) {
  Result<std::string> text = ReadFile(path);
  if (!text) throw std::runtime_error(path.string() + ": " + text.error().message);
  return std::move(text).value();
}

}  // namespace candela::docs
