#include "tests/kernel/random_group.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/transform.h"
#include "tests/kernel/sphere_set.h"

namespace candela::test {
namespace {

using Item = GroupDescription::Item;

bool Chance(UniformNumbers* random, float probability) {
  return random->Next() < probability;
}

/// Rejects hits by their numbers, as a surface with holes does.
class HoleFilter : public HitFilter {
 public:
  explicit HoleFilter(uint32_t seed) : seed_(seed) {}
  bool Accepts(const Ray& ray, const HitRecord& hit) const override {
    uint32_t hash = seed_ ^ hit.primitive * 0x9E3779B9u ^ hit.object * 0x85EBCA6Bu;
    for (const uint32_t nested : hit.nested) hash = (hash ^ nested) * 0xC2B2AE35u;
    hash ^= ray.mask & 1;
    return hash >> 30 != 0 && hit.u < 0.8f && hit.t > 0.01f;
  }

 private:
  uint32_t seed_;
};

/// Any affine map that leaves things about where they are: turns, mirrors, stretches, shears.
Mat4 RandomMatrix(UniformNumbers* random) {
  const auto number = [&](float low, float high) {
    return static_cast<double>(low + (high - low) * random->Next());
  };
  Mat4 matrix = Mat4::Translate(ToDouble(RandomPoint(random)));
  if (Chance(random, 0.2f)) return matrix;
  for (int axis = 0; axis < 3; ++axis) matrix = matrix * Mat4::Rotate(axis, number(0, 360));
  Vec3d scale{number(0.2f, 1.5f), number(0.2f, 1.5f), number(0.2f, 1.5f)};
  if (Chance(random, 0.3f)) scale.x = -scale.x;
  if (Chance(random, 0.1f)) scale.y *= 0.01;
  matrix = matrix * Mat4::Scale(scale);
  if (Chance(random, 0.4f)) {
    Mat4 shear = Mat4::Identity();
    shear.m[0][1] = number(-1, 1);
    shear.m[2][0] = number(-1, 1);
    matrix = matrix * shear;
  }
  return matrix;
}

TestMesh RandomMesh(GroupKind kind, UniformNumbers* random) {
  const Vec3 offset = RandomPoint(random);
  const float size = 0.1f + 0.9f * random->Next();
  switch (kind) {
    case GroupKind::kSoup:
      return Soup(1 + RandomIndex(random, 400), 0.02f, 0.5f, random);
    case GroupKind::kMixed:
      return Join({Soup(300, 1e-4f, 4, random), Slivers(60, 1e-3f, random),
                   Moved(Globe(6, 9), 0.01f, offset), Moved(CurvedGrid(12, 0.1f), 2, {0, 0, 0})});
    case GroupKind::kBoxes: {
      std::vector<TestMesh> boxes;
      for (int i = 0; i < 27; ++i) {
        const Vec3 low{static_cast<float>(i % 3) - 1, static_cast<float>(i / 3 % 3) - 1,
                       static_cast<float>(i / 9) - 1};
        boxes.push_back(BoxMesh(low, low + Vec3{1, 1, 1} * (i % 2 == 0 ? 0.5f : 1.0f)));
      }
      return Join(boxes);
    }
    default:
      break;
  }
  switch (RandomIndex(random, 5)) {
    case 0:
      return Moved(Globe(1 + RandomIndex(random, 12), 3 + RandomIndex(random, 14)), size, offset);
    case 1:
      return Moved(Star(15, 20, 5), size, offset);
    case 2:
      return Moved(CurvedGrid(1 + RandomIndex(random, 15), 0.3f), size, offset);
    case 3:
      return Moved(GridCube(1 + RandomIndex(random, 6)), size, offset);
    default:
      return Soup(1 + RandomIndex(random, 60), 0.05f, 1, random);
  }
}

std::shared_ptr<const PrimitiveSet> RandomSpheres(uint32_t steps, UniformNumbers* random) {
  std::vector<SphereSet::Sphere> spheres(1 + RandomIndex(random, 40));
  for (SphereSet::Sphere& sphere : spheres) {
    sphere.centers = {RandomPoint(random)};
    for (uint32_t step = 1; step < steps; ++step) {
      sphere.centers.push_back(sphere.centers.back() + RandomPoint(random) * 0.5f);
    }
    sphere.radius = 0.01f + 0.3f * random->Next() * random->Next();
  }
  return std::make_shared<SphereSet>(std::move(spheres));
}

GroupDescription RandomGroupBelow(GroupKind kind, int levels, UniformNumbers* random);

Item RandomInstance(const std::shared_ptr<const GroupDescription>& group, uint32_t steps,
                    UniformNumbers* random) {
  std::vector<Mat4> matrices = {RandomMatrix(random)};
  for (uint32_t step = 1; step < steps; ++step) {
    // Turning half way round would take it through a singular matrix.
    const Mat4 turn =
        Mat4::Rotate(static_cast<int>(step) % 3, 40 * static_cast<double>(random->Next()));
    matrices.push_back(Mat4::Translate(ToDouble(RandomPoint(random) * 0.3f)) * matrices.back() *
                       turn);
  }
  return {GroupDescription::Instance{group, matrices}, kAnyRay, nullptr};
}

GroupDescription RandomGroupBelow(GroupKind kind, int levels, UniformNumbers* random) {
  GroupDescription group;
  const bool everything = kind == GroupKind::kEverything;
  const bool moving = kind == GroupKind::kMoving || everything;
  const auto steps = [&]() -> uint32_t {
    return moving && Chance(random, 0.7f) ? 2 + RandomIndex(random, 3) : 1;
  };

  const uint32_t meshes = 1 + RandomIndex(random, 3);
  for (uint32_t i = 0; i < meshes; ++i) {
    TestMesh mesh = RandomMesh(kind, random);
    const uint32_t count = steps();
    if (count > 1) mesh = InMotion(mesh, count, 0.2f, random);
    group.Add(std::move(mesh));
    if (Chance(random, 0.2f)) group.items.push_back(group.items.back());
    if (Chance(random, 0.2f)) group.items.emplace_back();
  }
  if (kind == GroupKind::kSpheres || moving) {
    group.items.push_back({RandomSpheres(steps(), random), kAnyRay, nullptr});
    if (Chance(random, 0.5f)) group.items.push_back(group.items.back());
    if (kind == GroupKind::kSpheres && Chance(random, 0.5f)) {
      group.items.push_back({std::make_shared<GroundSet>(-0.7f), kAnyRay, nullptr});
    }
  }
  if ((kind == GroupKind::kInstances || moving) && levels > 0) {
    for (uint32_t i = 0; i < 2; ++i) {
      const auto inner = std::make_shared<GroupDescription>(
          RandomGroupBelow(kind, i == 0 ? levels - 1 : 0, random));
      const uint32_t instances = 1 + RandomIndex(random, 3);
      for (uint32_t j = 0; j < instances; ++j) {
        group.items.push_back(RandomInstance(inner, steps(), random));
        if (Chance(random, 0.1f)) group.items.push_back(group.items.back());
      }
    }
  }

  // Who is seen by whom, and where the holes are.
  for (Item& item : group.items) {
    if (Chance(random, 0.15f)) item.mask = 1 + RandomIndex(random, 7);
    if (Chance(random, 0.15f) &&
        !std::holds_alternative<GroupDescription::Instance>(item.content)) {
      item.filter = std::make_shared<HoleFilter>(RandomIndex(random, 1u << 20));
    }
  }
  // Meshes need not come first.
  GroupDescription turned;
  const size_t first = RandomIndex(random, group.items.size());
  for (size_t i = 0; i < group.items.size(); ++i) {
    turned.items.push_back(group.items[(first + i) % group.items.size()]);
  }
  return turned;
}

/// Vertices of the group's own meshes, at the first time step.
std::vector<Vec3> VerticesOf(const GroupDescription& group) {
  std::vector<Vec3> vertices;
  for (const Item& item : group.items) {
    if (const auto* mesh = std::get_if<1>(&item.content)) {
      const auto& positions = (*mesh)->positions;
      vertices.insert(vertices.end(), positions.begin(),
                      positions.begin() + static_cast<std::ptrdiff_t>((*mesh)->VertexCount()));
    }
  }
  if (vertices.empty()) vertices.push_back({0, 0, 0});
  return vertices;
}

}  // namespace

GroupDescription RandomGroup(GroupKind kind, UniformNumbers* random) {
  return RandomGroupBelow(kind, static_cast<int>(RandomIndex(random, 4)) + 1, random);
}

std::vector<Ray> RandomRays(const GroupDescription& group, size_t count, UniformNumbers* random) {
  const std::vector<Vec3> vertices = VerticesOf(group);
  const auto a_vertex = [&] { return vertices[RandomIndex(random, vertices.size())]; };
  const auto a_direction = [&](Vec3 origin) {
    switch (RandomIndex(random, 4)) {
      case 0:
        return a_vertex() - origin;
      case 1:
        return a_vertex() + RandomPoint(random) * 0.1f - origin;
      default:
        return RandomPoint(random) - origin;
    }
  };
  std::vector<Ray> rays;
  while (rays.size() < count) {
    const uint32_t choice = RandomIndex(random, 8);
    if (choice == 0) {
      // Along an axis, through a vertex or close to one.
      Vec3 origin = a_vertex(), direction;
      const auto axis = static_cast<int>(RandomIndex(random, 3));
      direction[axis] = Chance(random, 0.5f) ? 1.0f : -1.0f;
      if (Chance(random, 0.5f)) direction[(axis + 1) % 3] = -0.0f;
      if (Chance(random, 0.8f)) origin = origin - direction * 3;
      if (Chance(random, 0.3f)) origin += RandomPoint(random) * 0.01f;
      rays.emplace_back(origin, direction);
    } else if (choice == 1) {
      const Vec3 origin = RandomPoint(random) * 2, direction = a_direction(origin);
      const float time = random->Next();
      for (int i = 0; i < 16; ++i) {
        rays.emplace_back(origin, direction + RandomPoint(random) * 0.05f);
        rays.back().time = time;
      }
      continue;
    } else {
      const Vec3 origin = Chance(random, 0.1f) ? a_vertex() : RandomPoint(random) * 2;
      rays.emplace_back(origin, a_direction(origin));
    }
    Ray& ray = rays.back();
    ray.time = Chance(random, 0.2f) ? 0 : Chance(random, 0.1f) ? 1 : random->Next();
    if (Chance(random, 0.2f)) ray.mask = 1 + RandomIndex(random, 7);
    if (Chance(random, 0.2f)) ray.t_min = random->Next();
    if (Chance(random, 0.2f)) ray.t_max = 2 * random->Next();
    if (Chance(random, 0.1f)) ray.direction *= 1000.0f;
  }
  rays.resize(count);
  return rays;
}

}  // namespace candela::test
