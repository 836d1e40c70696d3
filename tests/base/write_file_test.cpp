#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <string_view>
#include <thread>

#include "base/files.h"
#include "tests/support/child.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing_support::Child;
using testing_support::Get;
using testing_support::Put;
using testing_support::RunAsOrdinaryUser;
using testing_support::TempFolder;

Result<void> Write(const fs::path& path, std::string_view text) {
  return WriteFileAtomically(path, std::as_bytes(std::span(text)));
}

/// The messages of the check before the work and of the write itself, which have to agree.
std::string Refusal(const fs::path& path) {
  const Result<void> checked = CheckWritable(path);
  const Result<void> written = Write(path, "x");
  if (checked || written) return "is not refused";
  EXPECT_EQ(checked.error().code, ErrorCode::kOutput);
  EXPECT_EQ(written.error().code, ErrorCode::kOutput);
  EXPECT_EQ(checked.error().message, written.error().message);
  return written.error().message;
}

mode_t ModeOf(const fs::path& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0);
  return status.st_mode & 07777;
}

TEST(WriteFile, MakesAndReplacesFiles) {
  const TempFolder folder;
  ASSERT_TRUE(Write(folder / "a.png", "old"));
  ASSERT_TRUE(Write(folder / "a.png", "new content"));
  ASSERT_TRUE(Write(folder / "empty", ""));
  EXPECT_EQ(Get(folder / "a.png"), "new content");
  EXPECT_THAT(folder.Names(), ElementsAre("a.png", "empty"));
}

TEST(WriteFile, TakesAPlainNameInTheWorkingFolder) {
  const TempFolder folder;
  EXPECT_EQ(Child([&] {
              fs::current_path(folder.path());
              return CheckWritable("plain") && Write("plain", "x") ? 0 : 1;
            }).Wait(),
            0);
  EXPECT_EQ(Get(folder / "plain"), "x");
}

TEST(WriteFile, TakesTheLongestNameThatTheFileSystemTakes) {
  const TempFolder folder;
  const fs::path path = folder / std::string(255, 'n');
  ASSERT_TRUE(CheckWritable(path));
  ASSERT_TRUE(Write(path, "x"));
  EXPECT_EQ(Get(path), "x");
}

TEST(WriteFile, KeepsTheModeOfAnOldFile) {
  const TempFolder folder;
  Put(folder / "old", "x");
  fs::permissions(folder / "old", fs::perms(0640));
  ASSERT_TRUE(Write(folder / "old", "y"));
  EXPECT_EQ(ModeOf(folder / "old"), 0640u);
}

TEST(WriteFile, GivesANewFileTheModeOfTheUmask) {
  const TempFolder folder;
  const mode_t umask_before = ::umask(0027);
  ASSERT_TRUE(Write(folder / "new", "x"));
  ::umask(umask_before);
  EXPECT_EQ(ModeOf(folder / "new"), 0640u);
}

TEST(WriteFile, FollowsSymbolicLinks) {
  const TempFolder folder;
  fs::create_directory(folder / "there");
  fs::create_symlink("there/file", folder / "relative");      // its file does not exist yet
  fs::create_symlink(folder / "relative", folder / "chain");  // absolute, and a link to a link
  ASSERT_TRUE(CheckWritable(folder / "chain"));
  ASSERT_TRUE(Write(folder / "chain", "one"));
  EXPECT_EQ(Get(folder / "there/file"), "one");
  ASSERT_TRUE(Write(folder / "relative", "two"));
  EXPECT_EQ(Get(folder / "there/file"), "two");
  EXPECT_TRUE(fs::is_symlink(folder / "chain") && fs::is_symlink(folder / "relative"));
}

TEST(WriteFile, WritesDevicesAndPipesDirectly) {
  const TempFolder folder;
  ASSERT_TRUE(CheckWritable("/dev/null"));
  ASSERT_TRUE(Write("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));

  const fs::path fifo = folder / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  ASSERT_TRUE(CheckWritable(fifo));
  std::string received;
  std::thread reader([&] { received = Get(fifo); });
  EXPECT_TRUE(Write(fifo, "through the pipe"));
  reader.join();
  EXPECT_EQ(received, "through the pipe");
  EXPECT_TRUE(fs::is_fifo(fifo));
}

// /dev/stdout is a link to a link whose text ("pipe:[123]") is not a path.
TEST(WriteFile, WritesTheStandardOutput) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  EXPECT_EQ(Child([&] {
              ::dup2(ends[1], STDOUT_FILENO);
              return CheckWritable("/dev/stdout") && Write("/dev/stdout", "out") ? 0 : 1;
            }).Wait(),
            0);
  char received[4] = {};
  ASSERT_EQ(::read(ends[0], received, 3), 3);
  EXPECT_STREQ(received, "out");
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(WriteFile, ReportsAFullDevice) {
  const Result<void> written = Write("/dev/full", "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kOutput);
  EXPECT_EQ(written.error().message, "cannot be written: No space left on device");
}

TEST(WriteFile, RefusesWhatCannotHoldAFile) {
  const TempFolder folder;
  Put(folder / "file", "x");
  fs::create_symlink("loop", folder / "loop");
  EXPECT_EQ(Refusal(""), "is not the name of a file");
  EXPECT_EQ(Refusal(folder.path() / ""), "is not the name of a file");
  EXPECT_EQ(Refusal(folder.path()), "is a folder");
  EXPECT_EQ(Refusal(folder / "missing/file"), "its folder does not exist");
  EXPECT_EQ(Refusal(folder / "file/file"), "its folder does not exist");
  EXPECT_EQ(Refusal(folder / "loop"), "is a symbolic link that leads nowhere");
  EXPECT_EQ(Refusal(folder / std::string(256, 'n')), "cannot be written: File name too long");
  EXPECT_THAT(folder.Names(), ElementsAre("file", "loop"));
}

TEST(WriteFile, RespectsPermissions) {
  const TempFolder folder;
  Put(folder / "file", "x");
  fs::create_directory(folder / "closed");
  fs::create_directory(folder / "open");
  fs::permissions(folder / "closed", fs::perms(0555));
  fs::permissions(folder / "open", fs::perms(0777));
  Put(folder / "open/protected", "x");
  fs::permissions(folder / "open/protected", fs::perms(0444));
  EXPECT_EQ(RunAsOrdinaryUser([&] {
              const std::string denied = "cannot be written: Permission denied";
              if (Refusal(folder / "closed/file") != denied) return 1;
              if (Refusal(folder / "open/protected") != denied) return 2;
              return Write(folder / "open/new", "x") ? 0 : 3;
            }),
            0);
  EXPECT_EQ(Get(folder / "open/protected"), "x");
  EXPECT_THAT(fs::is_empty(folder / "closed"), true);
}

TEST(CheckWritable, LeavesNothingBehindAndTheOldFileAlone) {
  const TempFolder folder;
  Put(folder / "old", "old");
  ASSERT_TRUE(CheckWritable(folder / "old"));
  ASSERT_TRUE(CheckWritable(folder / "new"));
  EXPECT_THAT(folder.Names(), ElementsAre("old"));
  EXPECT_EQ(Get(folder / "old"), "old");
}

TEST(WriteFile, RemovesWhatAKilledRunLeft) {
  const TempFolder folder;
  // No process has this number: it is above the largest that Linux gives. Where nobody can be asked
  // for it, the age of the file tells.
  Put(folder / ".a.png.candela-4194305.tmp", "left over");
  fs::last_write_time(folder / ".a.png.candela-4194305.tmp",
                      fs::file_time_type::clock::now() - std::chrono::hours(2));
  Put(folder / ".b.png.candela-4194305.tmp", "of another output");
  Put(folder / (".a.png.candela-" + std::to_string(::getppid()) + ".tmp"), "still being written");
  Put(folder / ".a.png.candela-notes.tmp", "of the user");
  ASSERT_TRUE(Write(folder / "a.png", "x"));
  EXPECT_THAT(folder.Names(),
              ElementsAre(".a.png.candela-" + std::to_string(::getppid()) + ".tmp",
                          ".a.png.candela-notes.tmp", ".b.png.candela-4194305.tmp", "a.png"));
}

TEST(IsSameFile, SeesThroughLinksAndDetours) {
  const TempFolder folder;
  Put(folder / "file", "x");
  fs::create_directory(folder / "below");
  fs::create_hard_link(folder / "file", folder / "hard");
  fs::create_symlink("new", folder / "link");
  EXPECT_TRUE(IsSameFile(folder / "file", folder / "hard"));
  EXPECT_TRUE(IsSameFile(folder / "file", folder / "below/../file"));
  EXPECT_TRUE(IsSameFile(folder / "new", folder / "link"));
  EXPECT_TRUE(IsSameFile(folder / "new", folder / "below/../new"));
  EXPECT_FALSE(IsSameFile(folder / "file", folder / "new"));
  EXPECT_FALSE(IsSameFile(folder / "new", folder / "newer"));
  // Relative paths of which nothing exists yet.
  EXPECT_TRUE(IsSameFile("a new file", "./a new file"));
  EXPECT_FALSE(IsSameFile("a new file", "./another new file"));
}

}  // namespace
}  // namespace candela
