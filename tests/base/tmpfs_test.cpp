// Outputs on a full and on a read-only disk. Takes the right to mount a file system.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "tests/support/temp_folder.h"
#include "tests/support/tmpfs.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing_support::Get;
using testing_support::TempFolder;
using testing_support::Tmpfs;

Result<void> Write(const std::filesystem::path& path, const std::string& text) {
  return WriteFileAtomically(path, std::as_bytes(std::span(text)));
}

TEST(WriteFile, KeepsTheOldFileWhenTheDiskIsFull) {
  const TempFolder folder;
  const Tmpfs disk(folder.path(), "size=256k,mode=755");
  if (!disk.ok()) GTEST_SKIP() << disk.reason();
  ASSERT_TRUE(Write(folder / "output", "old"));

  const Result<void> written = Write(folder / "output", std::string(1 << 20, 'x'));
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kOutput);
  EXPECT_EQ(written.error().message, "cannot be written: No space left on device");
  EXPECT_EQ(Get(folder / "output"), "old");
  EXPECT_THAT(folder.Names(), ElementsAre("output"));
}

TEST(WriteFile, RefusesAReadOnlyDisk) {
  const TempFolder folder;
  Tmpfs disk(folder.path(), "size=256k,mode=755");
  if (!disk.ok()) GTEST_SKIP() << disk.reason();
  ASSERT_TRUE(Write(folder / "output", "old"));
  ASSERT_TRUE(disk.MakeReadOnly());

  for (const char* name : {"output", "new"}) {
    const Result<void> checked = CheckWritable(folder / name);
    const Result<void> written = Write(folder / name, "new");
    ASSERT_FALSE(checked || written) << name;
    EXPECT_EQ(checked.error().message, "cannot be written: Read-only file system");
    EXPECT_EQ(written.error().message, checked.error().message);
  }
  EXPECT_EQ(Get(folder / "output"), "old");
}

}  // namespace
}  // namespace candela
