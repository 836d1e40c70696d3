#pragma once

#include <map>
#include <memory>
#include <variant>
#include <vector>

#include "kernel/group.h"
#include "tests/kernel/test_mesh.h"

namespace candela::test {

/// What a group is made of, in a form that owns everything and that a group can be built from.
struct GroupDescription {
  struct Instance {
    std::shared_ptr<const GroupDescription> group;
    std::vector<Mat4> world_from_group;
  };
  struct Item {
    std::variant<std::monostate, std::shared_ptr<const TestMesh>,
                 std::shared_ptr<const PrimitiveSet>, Instance>
        content;
    uint32_t mask = kAnyRay;
    std::shared_ptr<const HitFilter> filter;
  };
  std::vector<Item> items;

  void Add(TestMesh mesh) {
    items.push_back({std::make_shared<TestMesh>(std::move(mesh)), kAnyRay, nullptr});
  }
};

GroupDescription OfMesh(TestMesh mesh);

using BuiltGroups = std::map<const GroupDescription*, std::shared_ptr<const Group>>;

/// The input of a group; builds the groups inside that are not among those that were built before.
Result<GroupInput> InputOf(const GroupDescription& description, const BuildOptions& options,
                           BuiltGroups* built);
Result<GroupInput> InputOf(const GroupDescription& description, const BuildOptions& options);

Result<std::unique_ptr<Group>> Build(const GroupDescription& description,
                                     const BuildOptions& options);

/// The same, where it has to succeed.
std::unique_ptr<Group> MustBuild(const GroupDescription& description, const BuildOptions& options);

}  // namespace candela::test
