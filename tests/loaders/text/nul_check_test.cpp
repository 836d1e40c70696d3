#include "loaders/text/nul_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> Lines(std::string_view text) {
  Diagnostics diagnostics;
  const bool has_nul = HasNul(std::make_shared<const std::string>("a"), text, &diagnostics);
  EXPECT_EQ(has_nul, diagnostics.HasErrors());
  return diagnostics.Lines();
}

TEST(HasNul, ReportsTheFirstOneAtItsPlace) {
  using namespace std::string_view_literals;
  EXPECT_THAT(Lines("\0"sv), ElementsAre("a:1:1: error: a text file is due, found a NUL byte"));
  EXPECT_THAT(Lines("ab\0\0"sv), ElementsAre("a:1:3: error: a text file is due, found a NUL byte"));
  EXPECT_THAT(Lines("a\n\nbc\0"sv),
              ElementsAre("a:3:3: error: a text file is due, found a NUL byte"));
}

TEST(HasNul, TextHasNone) {
  EXPECT_THAT(Lines(""), IsEmpty());
  EXPECT_THAT(Lines("a\n0\x01\xff"), IsEmpty());
}

}  // namespace
}  // namespace candela
