#include "scene_spec/registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Entry {
  std::string_view name;
};
constexpr Entry kTable[] = {{"cone"}, {"torus"}};

TEST(FindEntry, FindsTheRowOfAType) {
  Diagnostics diagnostics;
  EXPECT_EQ(FindEntry<Entry>(kTable, {"torus", {}, {}}, "shape", &diagnostics), &kTable[1]);
  EXPECT_THAT(diagnostics.Lines(), IsEmpty());
}

TEST(FindEntry, UnknownTypesGetTheListAndTheNearest) {
  Diagnostics diagnostics;
  EXPECT_EQ(FindEntry<Entry>(kTable, {"tours", {}, {}}, "shape", &diagnostics), nullptr);
  EXPECT_EQ(FindEntry<Entry>(kTable, {"Cone", {}, {}}, "shape", &diagnostics), nullptr);
  EXPECT_EQ(FindEntry<Entry>(kTable, {"plane", {}, {}}, "shape", &diagnostics), nullptr);
  EXPECT_THAT(
      diagnostics.Lines(),
      ElementsAre("error: there is no shape of type 'tours' (did you mean 'torus'?); known: "
                  "'cone' or 'torus'",
                  "error: there is no shape of type 'Cone' (did you mean 'cone'?); known: 'cone' "
                  "or 'torus'",
                  "error: there is no shape of type 'plane'; known: 'cone' or 'torus'"));
}

TEST(FindEntry, AMissingTypeWasReportedBefore) {
  Diagnostics diagnostics;
  EXPECT_EQ(FindEntry<Entry>(kTable, {}, "shape", &diagnostics), nullptr);
  EXPECT_THAT(diagnostics.Lines(), IsEmpty());
}

}  // namespace
}  // namespace candela
