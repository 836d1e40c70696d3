// The course's seven scenes against the pictures of its reference implementation.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/image_reference/reference_pictures.h"
#include "tests/image_reference/reference_table.h"
#include "tests/support/generated_part.h"
#include "tests/support/picture_check.h"

namespace candela::image_reference {
namespace {

class Reference : public testing::TestWithParam<ReferencePicture> {};

// P18
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
  testing_support::ExpectGeneratedPart("docs/testing.md", "reference table", ReferenceTable());
}

}  // namespace
}  // namespace candela::image_reference
