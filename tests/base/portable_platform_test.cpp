// What the portable platform answers differently, which also shows that it is the one under test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "base/files.h"
#include "base/memory.h"
#include "base/platform.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing_support::Put;
using testing_support::TempFolder;

TEST(PortablePlatform, DoesNotClaimToKnowTheSystem) {
  EXPECT_EQ(PeakMemory(), 0u);
  EXPECT_FALSE(platform::IsErrorTerminal());
  EXPECT_EQ(platform::ErrorTerminalColumns(), 0);
}

// It cannot ask whether a process lives, and rather leaves a file than takes it from its writer.
TEST(PortablePlatform, TellsALeftoverByItsAge) {
  const TempFolder folder;
  const auto now = fs::file_time_type::clock::now();
  for (const int minutes : {59, 61}) {
    const fs::path left = folder / (".a.png.candela-" + std::to_string(minutes) + ".tmp");
    Put(left, "left over");
    fs::last_write_time(left, now - std::chrono::minutes(minutes));
  }
  ASSERT_TRUE(WriteFileAtomically(folder / "a.png", {}));
  EXPECT_THAT(folder.Names(), ElementsAre(".a.png.candela-59.tmp", "a.png"));
}

}  // namespace
}  // namespace candela
