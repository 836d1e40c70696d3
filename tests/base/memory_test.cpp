#include "base/memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <vector>

#include "tests/support/temp_folder.h"

namespace candela {
namespace {

using testing_support::Put;
using testing_support::TempFolder;

constexpr uint64_t kMebibyte = 1 << 20;
constexpr uint64_t kUnlimited = ~uint64_t{0};

TEST(AvailableMemory, IsPartOfWhatTheMachineHas) {
  const uint64_t installed = static_cast<uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                             static_cast<uint64_t>(::sysconf(_SC_PAGESIZE));
  EXPECT_GT(AvailableMemory(), 16 * kMebibyte);
  EXPECT_LT(AvailableMemory(), installed);
}

TEST(PeakMemory, SeesWhatIsTouched) {
  const uint64_t before = PeakMemory();
  ASSERT_GT(before, 0u);
  const std::vector<char> block(64 * kMebibyte + before, 'x');
  EXPECT_GE(PeakMemory(), 64 * kMebibyte + before) << block[before];
}

TEST(ControlGroupMemory, IsUnlimitedWithoutGroups) {
  const TempFolder folder;
  EXPECT_EQ(ControlGroupMemoryLeft(folder / "missing", folder.path()), kUnlimited);
  Put(folder / "groups", "0::/\n");
  EXPECT_EQ(ControlGroupMemoryLeft(folder / "groups", folder.path()), kUnlimited);
  Put(folder / "memory.max", "max\n");
  Put(folder / "memory.current", "1000\n");
  EXPECT_EQ(ControlGroupMemoryLeft(folder / "groups", folder.path()), kUnlimited);
}

// The tightest group on the way to the root decides; cached file pages can be given back.
TEST(ControlGroupMemory, Version2) {
  const TempFolder folder;
  Put(folder / "groups", "0::/outer/inner\n");
  std::filesystem::create_directories(folder / "outer/inner");
  Put(folder / "outer/inner/memory.max", "9000\n");
  Put(folder / "outer/inner/memory.current", "1000\n");
  EXPECT_EQ(ControlGroupMemoryLeft(folder / "groups", folder.path()), 8000u);
  Put(folder / "outer/memory.max", "5000\n");
  Put(folder / "outer/memory.current", "3000\n");
  EXPECT_EQ(ControlGroupMemoryLeft(folder / "groups", folder.path()), 2000u);
  Put(folder / "outer/memory.stat", "anon 500\ninactive_file 2500\nactive_file 0\n");
  EXPECT_EQ(ControlGroupMemoryLeft(folder / "groups", folder.path()), 4500u);
  Put(folder / "outer/memory.current", "9999\n");
  EXPECT_EQ(ControlGroupMemoryLeft(folder / "groups", folder.path()), 0u);
}

TEST(ControlGroupMemory, Version1) {
  const TempFolder folder;
  Put(folder / "groups", "5:cpu,cpuacct:/job\n4:memory:/job\n1:name=systemd:/\n");
  std::filesystem::create_directories(folder / "memory/job");
  Put(folder / "memory/job/memory.limit_in_bytes", "5000\n");
  Put(folder / "memory/job/memory.usage_in_bytes", "3000\n");
  Put(folder / "memory/job/memory.stat", "inactive_file 1\ntotal_inactive_file 500\n");
  EXPECT_EQ(ControlGroupMemoryLeft(folder / "groups", folder.path()), 2500u);
}

}  // namespace
}  // namespace candela
