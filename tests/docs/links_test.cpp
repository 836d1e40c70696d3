// The documents lead only to files and headings that exist.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/docs/markdown.h"

namespace candela::docs {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;

/// All documents of the project; builds and rendered pictures have folders of their own.
std::vector<fs::path> Documents() {
  std::vector<fs::path> documents;
  for (fs::recursive_directory_iterator entry("."), end; entry != end; ++entry) {
    const std::string name = entry->path().filename().string();
    const bool is_folder = entry->is_directory();
    const bool is_hidden = name.size() > 1 && name[0] == '.';
    if (is_folder && (is_hidden || name.starts_with("build") || name == "out")) {
      entry.disable_recursion_pending();
    }
    if (!is_folder && entry->path().extension() == ".md") documents.push_back(entry->path());
  }
  std::sort(documents.begin(), documents.end());
  return documents;
}

TEST(Links, LeadToFilesAndHeadingsThatExist) {
  size_t count = 0;
  for (const fs::path& document : Documents()) {
    for (const Link& link : LocalLinks(ReadDocument(document))) {
      SCOPED_TRACE(document.string() + ":" + std::to_string(link.line) + ": " + link.target);
      ++count;
      const size_t mark = link.target.find('#');
      const std::string file = link.target.substr(0, mark);
      const fs::path path = file.empty() ? document : document.parent_path() / file;
      ASSERT_TRUE(fs::exists(path));
      if (mark == std::string::npos) continue;
      EXPECT_THAT(Anchors(ReadDocument(path)), Contains(link.target.substr(mark + 1)));
    }
  }
  EXPECT_GE(count, 30u) << "the test looked in the wrong place";
}

TEST(LocalLinks, AreFoundOutsideCodeOnly) {
  const std::vector<Link> links = LocalLinks(
      "see [a](a.md) and ![b](b.png)\n"
      "not `[c](c.md)` or [d](https://example.org/d)\n"
      "```\n[e](e.md)\n```\n"
      "[f](#f)\n");
  ASSERT_EQ(links.size(), 3u);
  EXPECT_EQ(links[0].target, "a.md");
  EXPECT_EQ(links[1].target, "b.png");
  EXPECT_EQ(links[2].target, "#f");
  EXPECT_EQ(links[2].line, 6);
}

TEST(Anchors, AreThoseOfGitHub) {
  EXPECT_THAT(Anchors("# 2. Who may include whom\n```\n# no heading\n```\n## `render`: a_b\n"),
              ElementsAre("2-who-may-include-whom", "render-a_b"));
}

}  // namespace
}  // namespace candela::docs
