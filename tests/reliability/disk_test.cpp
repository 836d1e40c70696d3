// The programs on a full and on a read-only disk. Takes the right to mount a file system.
#include <optional>

#include "tests/apps/programs.h"
#include "tests/support/tmpfs.h"

namespace candela::testing_support {
namespace {

using testing::ElementsAre;

class Disk : public ProgramTest {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(folder_ / "disk");
    disk_.emplace(folder_ / "disk", "size=12k,mode=755");
    if (!disk_->ok()) GTEST_SKIP() << disk_->reason();
  }

  std::vector<std::string> NamesOnDisk() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "disk")) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }

  std::optional<Tmpfs> disk_;
};

TEST_F(Disk, ThatIsFullKeepsTheOldPicture) {
  for (const char* name : {"disk/o.png", "disk/o.pfm"}) {
    Put(folder_ / name, "old");
    ExpectRefusal(Assignment4({"-input", "scene.txt", "-output", name, "-size", "800", "800"}), 3,
                  std::string("assignment4: error: '") + name +
                      "': cannot be written: No space left on device");
    EXPECT_TRUE(Bytes(name) == "old");
    EXPECT_EQ(NamesOnDisk().size(), 1u) << "a temporary file is left";
    std::filesystem::remove(folder_ / name);
  }
}

TEST_F(Disk, ThatIsReadOnlyIsRefusedBeforeTheSceneIsRead) {
  Put(folder_ / "disk/o.png", "old");
  Put(folder_ / "broken.txt", "nonsense");
  ASSERT_TRUE(disk_->MakeReadOnly());
  for (const char* name : {"disk/o.png", "disk/new.png"}) {
    ExpectRefusal(Assignment4({"-input", "broken.txt", "-output", name}), 3,
                  std::string("assignment4: error: '") + name +
                      "': cannot be written: Read-only file system");
  }
  EXPECT_TRUE(Bytes("disk/o.png") == "old");
  EXPECT_THAT(NamesOnDisk(), ElementsAre("o.png"));
}

// What a render has cost is lost only where both the picture and the checkpoint cannot be written.
TEST_F(Disk, WithoutSpaceForTheCheckpointHasThePicture) {
  const std::vector<std::string> plain = {"render", "scene.txt", "--size", "64", "64", "--quiet"};
  const auto render = [&](const std::string& picture, const std::string& checkpoint) {
    auto arguments = plain;
    arguments.insert(arguments.end(), {"-o", picture, "--checkpoint", checkpoint});
    return Candela(arguments);
  };
  EXPECT_EQ(render("both.pfm", "both.bin").status, 0);
  ExpectRefusal(render("o.pfm", "disk/c.bin"), 3,
                "candela render: error: 'disk/c.bin': cannot be written: No space left on device");
  EXPECT_TRUE(Bytes("o.pfm") == Bytes("both.pfm"));
  ExpectRefusal(render("disk/o.pfm", "c.bin"), 3,
                "candela render: error: 'disk/o.pfm': cannot be written: No space left on device");
  EXPECT_TRUE(Bytes("c.bin") == Bytes("both.bin"));
  EXPECT_EQ(NamesOnDisk().size(), 0u);
}

}  // namespace
}  // namespace candela::testing_support
