#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>

#include "base/files.h"
#include "tests/support/child.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

using testing_support::Put;
using testing_support::RunAsOrdinaryUser;
using testing_support::TempFolder;

std::string MessageFor(const std::filesystem::path& path) {
  const auto content = ReadFile(path);
  return content ? "was read" : content.error().message;
}

TEST(ReadFile, GivesEveryByte) {
  const TempFolder folder;
  const std::string bytes("a\0\r\n\xff\x1a z", 8);
  Put(folder / "file", bytes);
  Put(folder / "empty", "");
  std::filesystem::create_symlink("file", folder / "link");
  EXPECT_EQ(*ReadFile(folder / "file"), bytes);
  EXPECT_EQ(*ReadFile(folder / "link"), bytes);
  EXPECT_EQ(*ReadFile(folder / "empty"), "");
}

TEST(ReadFile, NamesWhatIsNotThere) {
  const TempFolder folder;
  Put(folder / "file", "");
  std::filesystem::create_symlink("nowhere", folder / "dangling");
  std::filesystem::create_symlink("loop", folder / "loop");
  EXPECT_EQ(MessageFor(""), "no such file");
  EXPECT_EQ(MessageFor(folder / "missing"), "no such file");
  EXPECT_EQ(MessageFor(folder / "missing/file"), "no such file");
  EXPECT_EQ(MessageFor(folder / "file/below"), "no such file");
  EXPECT_EQ(MessageFor(folder / "dangling"), "no such file");
  EXPECT_EQ(MessageFor(folder / "loop"), "Too many levels of symbolic links");
  EXPECT_EQ(MessageFor(folder / std::string(300, 'x')), "File name too long");
  EXPECT_EQ(ReadFile(folder / "missing").error().code, ErrorCode::kInput);
}

// A FIFO without a writer would block for ever when opened.
TEST(ReadFile, NamesWhatIsNotARegularFile) {
  const TempFolder folder;
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  const int listener = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, (folder / "socket").c_str(), sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);

  EXPECT_EQ(MessageFor(folder.path()), "is a folder, not a file");
  EXPECT_EQ(MessageFor("/dev/zero"), "is a device, not a file");
  EXPECT_EQ(MessageFor(folder / "fifo"), "is a pipe, not a file");
  EXPECT_EQ(MessageFor(folder / "socket"), "is a socket, not a file");
  ::close(listener);
}

TEST(ReadFile, RespectsPermissions) {
  const TempFolder folder;
  Put(folder / "secret", "x");
  std::filesystem::permissions(folder / "secret", std::filesystem::perms::none);
  EXPECT_EQ(RunAsOrdinaryUser(
                [&] { return MessageFor(folder / "secret") == "Permission denied" ? 0 : 1; }),
            0);
}

// The file occupies no space on the disk, so only its size tells that it cannot be read.
TEST(ReadFile, RefusesWhatDoesNotFitIntoMemory) {
  const TempFolder folder;
  Put(folder / "huge", "");
  ASSERT_EQ(::truncate((folder / "huge").c_str(), int64_t{1} << 43), 0) << std::strerror(errno);
  const auto content = ReadFile(folder / "huge");
  ASSERT_FALSE(content);
  EXPECT_EQ(content.error().code, ErrorCode::kResources);
  EXPECT_EQ(content.error().message, "does not fit into memory");
}

}  // namespace
}  // namespace candela
