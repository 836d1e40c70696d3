// The page about the architecture shows the rules that are checked and the folders that there are.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/docs/markdown.h"
#include "tests/layering/layering_rules.h"

namespace candela::docs {
namespace {

using testing::HasSubstr;

constexpr const char* kPage = "docs/architecture.md";

TEST(Architecture, ShowsWhoMayIncludeWhom) {
  std::string expected;
  for (const layering::Row& row : layering::Table()) {
    const std::string_view blank = row.may_include.empty() ? "" : " ";
    expected += fmt::format("{} ->{}{}\n", row.folder, blank, fmt::join(row.may_include, ", "));
  }
  std::string shown;
  for (const FencedBlock& block : FencedBlocks(ReadDocument(kPage))) {
    if (block.Language() == "layers") shown = block.text;
  }
  EXPECT_EQ(shown, expected);
}

TEST(Architecture, NamesEveryFolderOfTheSources) {
  const std::string folders = FencedBlocks(ReadDocument(kPage))[0].text;
  for (const char* root : {"src", "apps"}) {
    for (const auto& entry : std::filesystem::directory_iterator(root)) {
      if (!entry.is_directory()) continue;
      EXPECT_THAT(folders, HasSubstr(" " + entry.path().filename().string() + "/"));
    }
  }
}

}  // namespace
}  // namespace candela::docs
