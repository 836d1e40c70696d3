#include "tests/kernel/group_description.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/triangle.h"
#include "math/transform.h"

namespace candela::test {
namespace {

/// Between two time steps. A vertex that is not finite at one of them is not a number.
std::vector<Vec3> PositionsAt(const TestMesh& mesh, float time) {
  const float position = time * static_cast<float>(mesh.steps - 1);
  const uint32_t step = std::min(static_cast<uint32_t>(position), mesh.steps - 2);
  const float part = position - static_cast<float>(step);
  const size_t count = mesh.VertexCount();
  std::vector<Vec3> positions(count);
  for (size_t i = 0; i < count; ++i) {
    const Vec3* const at_step = &mesh.positions[step * count + i];
    positions[i] = at_step[0] * (1 - part) + at_step[count] * part;
    for (size_t j = i; j < mesh.positions.size(); j += count) {
      if (!IsFinite(mesh.positions[j])) positions[i].x = std::numeric_limits<float>::quiet_NaN();
    }
  }
  return positions;
}

/// A search for the nearest hit.
class Reference {
 public:
  Reference(const Ray& asked, HitRecord* hit) : asked_(asked), hit_(hit) {}

  void Visit(const GroupDescription& group, const Ray& ray) {
    const float length = LengthSquared(ray.direction);
    if (!(length > 0 && std::isfinite(length) && IsFinite(ray.origin) && ray.t_min >= 0)) return;
    for (uint32_t i = 0; i < group.items.size(); ++i) {
      const GroupDescription::Item& item = group.items[i];
      if ((item.mask & asked_.mask) == 0) continue;
      path_.push_back(i);
      if (const auto* mesh = std::get_if<1>(&item.content)) VisitMesh(item, **mesh, ray);
      if (const auto* set = std::get_if<2>(&item.content)) VisitSet(item, **set, ray);
      if (const auto* inner = std::get_if<3>(&item.content)) VisitInstance(*inner, ray);
      path_.pop_back();
    }
  }

 private:
  /// Takes a hit that is nearer than the one before, if it counts.
  void Offer(const GroupDescription::Item& item, uint32_t primitive, HitRecord found) {
    found.object = path_[0];
    for (size_t i = 1; i < path_.size(); ++i) found.nested[i - 1] = path_[i];
    found.primitive = primitive;
    if (!item.filter || item.filter->Accepts(asked_, found)) *hit_ = found;
  }

  HitRecord Limit() const {
    HitRecord limit;
    limit.t = hit_->t;
    return limit;
  }

  void VisitMesh(const GroupDescription::Item& item, const TestMesh& mesh, const Ray& ray) {
    const ShearedRay sheared(ray);
    const std::vector<Vec3> moved =
        mesh.steps > 1 ? PositionsAt(mesh, ray.time) : std::vector<Vec3>();
    const std::vector<Vec3>& positions = mesh.steps > 1 ? moved : mesh.positions;
    for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& [a, b, c] = mesh.triangles[i];
      HitRecord found = Limit();
      if (IntersectTriangle(sheared, ray.t_min, positions[a], positions[b], positions[c], &found)) {
        Offer(item, i, found);
      }
    }
  }

  void VisitSet(const GroupDescription::Item& item, const PrimitiveSet& set, const Ray& ray) {
    for (uint32_t i = 0; i < set.PrimitiveCount(); ++i) {
      HitRecord found = Limit();
      if (set.IntersectPrimitive(ray, i, &found)) Offer(item, i, found);
    }
  }

  void VisitInstance(const GroupDescription::Instance& instance, const Ray& ray) {
    const std::vector<Mat4>& steps = instance.world_from_group;
    Mat4 matrix = steps[0];
    if (steps.size() > 1) {
      const double position = static_cast<double>(ray.time) * static_cast<double>(steps.size() - 1);
      const size_t step = std::min(static_cast<size_t>(position), steps.size() - 2);
      const double part = position - static_cast<double>(step);
      for (size_t row = 0; row < 4; ++row) {
        for (size_t column = 0; column < 4; ++column) {
          matrix.m[row][column] =
              steps[step].m[row][column] * (1 - part) + steps[step + 1].m[row][column] * part;
        }
      }
    }
    const auto inverse = InverseAffine(matrix);
    if (!inverse) return;
    const Transform group_from_world(*inverse);
    Ray inner = ray;
    inner.origin = group_from_world.Point(ray.origin);
    inner.direction = group_from_world.Vector(ray.direction);
    Visit(*instance.group, inner);
  }

  const Ray& asked_;
  HitRecord* hit_;
  std::vector<uint32_t> path_;
};

}  // namespace

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

bool IntersectAll(const GroupDescription& description, const Ray& ray, HitRecord* hit) {
  Ray clamped = ray;
  if (!(clamped.time >= 0)) clamped.time = 0;  // NaN too.
  if (clamped.time > 1) clamped.time = 1;
  HitRecord nearest = *hit;
  nearest.object = HitRecord::kNone;
  Reference(ray, &nearest).Visit(description, clamped);
  if (!nearest.IsHit()) return false;
  *hit = nearest;
  return true;
}

}  // namespace candela::test
