#include "tests/kernel/group_description.h"

#include <utility>

namespace candela::test {
GroupDescription OfMesh(TestMesh mesh) {
  GroupDescription description;
  description.Add(std::move(mesh));
  return description;
}

Result<GroupInput> InputOf(const GroupDescription& description, const BuildOptions& options,
                           BuiltGroups* built) {
  GroupInput input;
  for (const GroupDescription::Item& from : description.items) {
    GroupItem item;
    item.mask = from.mask;
    item.filter = from.filter.get();
    if (const auto* mesh = std::get_if<1>(&from.content)) {
      item.content = TriangleInput{(*mesh)->positions, (*mesh)->triangles, (*mesh)->steps};
    } else if (const auto* set = std::get_if<2>(&from.content)) {
      item.content = PrimitiveInput{set->get()};
    } else if (const auto* instance = std::get_if<3>(&from.content)) {
      std::shared_ptr<const Group>& group = (*built)[instance->group.get()];
      if (!group) {
        auto inner = InputOf(*instance->group, options, built);
        if (!inner) return inner.error();
        auto inner_group = Group::Build(*std::move(inner), options);
        if (!inner_group) return inner_group.error();
        group = *std::move(inner_group);
      }
      item.content = InstanceInput{group, instance->world_from_group};
    }
    input.push_back(std::move(item));
  }
  return input;
}

Result<GroupInput> InputOf(const GroupDescription& description, const BuildOptions& options) {
  BuiltGroups built;
  return InputOf(description, options, &built);
}

Result<std::unique_ptr<Group>> Build(const GroupDescription& description,
                                     const BuildOptions& options) {
  auto input = InputOf(description, options);
  if (!input) return input.error();
  return Group::Build(*std::move(input), options);
}

std::unique_ptr<Group> MustBuild(const GroupDescription& description, const BuildOptions& options) {
  auto group = Build(description, options);
  CHECK(group.ok());
  return *std::move(group);
}

}  // namespace candela::test
