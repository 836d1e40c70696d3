#include "driver/find_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace candela {
namespace {

using testing_support::Put;
using testing_support::TempFolder;

TEST(FindScene, TakesThePathAsGivenFirst) {
  const TempFolder here, shipped;
  Put(here / "a.txt", "");
  Put(shipped / "a.txt", "");
  EXPECT_EQ(*FindScene(here / "a.txt", {shipped.path()}), here / "a.txt");
  // A folder exists too; that it is no file is for the reader to say.
  EXPECT_EQ(*FindScene(here.path(), {}), here.path());
}

TEST(FindScene, LooksInTheFoldersInOrder) {
  const TempFolder one, two;
  Put(two / "only_in_two.txt", "");
  EXPECT_EQ(*FindScene("only_in_two.txt", {one.path(), two.path()}), two / "only_in_two.txt");
  Put(one / "only_in_two.txt", "");
  EXPECT_EQ(*FindScene("only_in_two.txt", {one.path(), two.path()}), one / "only_in_two.txt");
}

TEST(FindScene, TellsWhereItLookedAndTheNearestName) {
  const TempFolder shipped;
  Put(shipped / "scene06_bunny_1k.txt", "");
  Put(shipped / "scene06_bunny_1k.png", "");
  const auto found = FindScene("scene6_bunny_1k.txt", {shipped.path()});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kInput);
  EXPECT_EQ(
      found.error().message,
      "there is no scene 'scene6_bunny_1k.txt' (did you mean 'scene06_bunny_1k.txt'?); looked "
      "for it as given, in '" +
          shipped.path().string() + "'");
}

TEST(FindScene, AnAbsolutePathIsOnlyLookedForAsGiven) {
  const TempFolder here;
  Put(here / "arch.txt", "");
  const auto found = FindScene(here / "acrh.txt", {here.path()});
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().message, testing::EndsWith("(did you mean 'arch.txt'?); looked for it "
                                                       "as given"));
}

TEST(SceneFolders, AreThoseOfTheWorkingFolderTheProgramAndTheInstallation) {
  const auto folders = SceneFolders();
  ASSERT_EQ(folders.size(), 3u);
  EXPECT_EQ(folders[0], "assets/assignment4");
  EXPECT_THAT(folders[1].string(), testing::EndsWith("/assets/assignment4"));
  EXPECT_THAT(folders[2].string(), testing::EndsWith("/share/candela/assets/assignment4"));
}

}  // namespace
}  // namespace candela
