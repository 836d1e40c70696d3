// The course's seven scenes against the pictures of its reference implementation.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <span>

#include "base/files.h"
#include "tests/image_reference/reference_pictures.h"
#include "tests/image_reference/reference_table.h"
#include "tests/support/picture_check.h"

namespace candela::image_reference {
namespace {

// Where the measured table stands in the documents.
constexpr const char* kDocument = "docs/testing.md";
constexpr const char* kPart = "reference table";

class Reference : public testing::TestWithParam<ReferencePicture> {};

TEST_P(Reference, PictureMeetsTheBar) {
  if (!HaveReference()) GTEST_SKIP() << NoReference();
  const ReferencePicture& picture = GetParam();
  const Comparison& comparison = CompareWithReference(picture);
  const ImageDifference& difference = comparison.difference;
  EXPECT_TRUE(comparison.Meets(picture.bar()))
      << fmt::format(
             "of {} pixels {} differ, {} by more than one level, at most by {:.0f}; {:.2f} dB; ",
             comparison.compared, difference.differing, difference.beyond_one_level,
             difference.LargestInLevels(), difference.psnr)
      << testing_support::StoreForInspection(picture.Name(), comparison.ours, comparison.reference);
}

INSTANTIATE_TEST_SUITE_P(Pictures, Reference, testing::ValuesIn(ReferencePictures()),
                         [](const auto& test) { return test.param.Name(); });

// With CANDELA_UPDATE=1 the table is written instead.
TEST(ReferenceTable, OfTheDocumentIsWhatIsMeasured) {
  if (!HaveReference()) GTEST_SKIP() << NoReference();
  const std::string table = ReferenceTable();
  const Result<std::string> document = ReadFile(kDocument);
  ASSERT_TRUE(document) << kDocument << ": " << document.error().message;
  if (testing_support::IsUpdate()) {
    const Result<std::string> updated = ReplaceGeneratedPart(*document, kPart, table);
    ASSERT_TRUE(updated) << updated.error().message;
    ASSERT_TRUE(WriteFileAtomically(kDocument, std::as_bytes(std::span(*updated))));
    return;
  }
  const Result<std::string> part = GeneratedPart(*document, kPart);
  ASSERT_TRUE(part) << part.error().message;
  EXPECT_EQ(*part, table) << "CANDELA_UPDATE=1 makes this test write the table";
}

}  // namespace
}  // namespace candela::image_reference
