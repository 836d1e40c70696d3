#include "tests/support/generated_part.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <span>

#include "base/files.h"
#include "tests/support/picture_check.h"

namespace candela::testing_support {

void ExpectGeneratedPart(const std::filesystem::path& document, std::string_view name,
                         const std::string& expected) {
  const Result<std::string> text = ReadFile(document);
  ASSERT_TRUE(text) << document << ": " << text.error().message;
  const std::string first = fmt::format("<!-- begin: {} -->\n", name);
  const std::string last = fmt::format("<!-- end: {} -->\n", name);
  const size_t first_at = text->find(first), end = text->find(last);
  ASSERT_TRUE(first_at != text->npos && end != text->npos && first_at < end)
      << document << " has no part '" << name << "'";
  const size_t begin = first_at + first.size();
  if (IsUpdate()) {
    const std::string updated = text->substr(0, begin) + expected + text->substr(end);
    ASSERT_TRUE(WriteFileAtomically(document, std::as_bytes(std::span(updated))));
    return;
  }
  EXPECT_EQ(text->substr(begin, end - begin), expected)
      << "CANDELA_UPDATE=1 makes this test write the part";
}

}  // namespace candela::testing_support
