#include "tests/kernel/full_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/triangle.h"
#include "math/transform.h"

namespace candela::test {
namespace {

/// The triangles of a mesh as nine rows of numbers: most of what a ray misses is told by a loop
/// that the compiler turns into one over lanes.
class TriangleRows {
 public:
  explicit TriangleRows(const TestMesh& mesh)
      : count_(mesh.triangles.size()), steps_(mesh.steps), numbers_(steps_ * 9 * count_) {
    const size_t vertices = mesh.VertexCount();
    for (size_t step = 0; step < steps_; ++step) {
      for (size_t i = 0; i < count_; ++i) {
        for (size_t corner = 0; corner < 3; ++corner) {
          const uint32_t vertex = mesh.triangles[i][corner];
          Vec3 p = mesh.positions[step * vertices + vertex];
          if (steps_ > 1 && !IsFiniteAlways(mesh, vertex)) p.x = kNaN;
          for (int axis = 0; axis < 3; ++axis) {
            numbers_[Row(step, 3 * corner + static_cast<size_t>(axis)) + i] = p[axis];
          }
        }
      }
    }
  }

  /// Calls `visit(index, a, b, c)` for those that the ray may hit, in their order.
  template <class Visit>
  void ForEachCandidate(const ShearedRay& ray, float time, Visit visit) const {
    Block block;
    for (size_t begin = 0; begin < count_; begin += kBlock) {
      const size_t count = std::min(kBlock, count_ - begin);
      Take(begin, count, time, &block);
      std::array<int32_t, kBlock> may_hit;
      Judge(ray, block, count, &may_hit);
      for (size_t i = 0; i < count; ++i) {
        if (!may_hit[i]) continue;
        const auto corner = [&](size_t first) {
          return Vec3{block[first][i], block[first + 1][i], block[first + 2][i]};
        };
        visit(static_cast<uint32_t>(begin + i), corner(0), corner(3), corner(6));
      }
    }
  }

 private:
  static constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  static constexpr size_t kBlock = 128;
  using Block = std::array<std::array<float, kBlock>, 9>;

  /// A vertex that is not finite at one of the time steps is never hit.
  static bool IsFiniteAlways(const TestMesh& mesh, size_t vertex) {
    for (size_t i = vertex; i < mesh.positions.size(); i += mesh.VertexCount()) {
      if (!IsFinite(mesh.positions[i])) return false;
    }
    return true;
  }

  size_t Row(size_t step, size_t coordinate) const { return (9 * step + coordinate) * count_; }

  void Take(size_t begin, size_t count, float time, Block* block) const {
    if (steps_ == 1) {
      for (size_t row = 0; row < 9; ++row) {
        std::copy_n(&numbers_[Row(0, row) + begin], count, (*block)[row].begin());
      }
      return;
    }
    const float position = time * static_cast<float>(steps_ - 1);
    const size_t step = std::min(static_cast<size_t>(position), steps_ - 2);
    const float part = position - static_cast<float>(step);
    for (size_t row = 0; row < 9; ++row) {
      const float* const before = &numbers_[Row(step, row) + begin];
      const float* const after = &numbers_[Row(step + 1, row) + begin];
      float* const now = (*block)[row].data();
      for (size_t i = 0; i < count; ++i) now[i] = before[i] * (1 - part) + after[i] * part;
    }
  }

  /// The first question of `IntersectTriangle`, by the same numbers.
  static void Judge(const ShearedRay& ray, const Block& block, size_t count,
                    std::array<int32_t, kBlock>* may_hit) {
    const auto kx = static_cast<size_t>(ray.kx), ky = static_cast<size_t>(ray.ky),
               kz = static_cast<size_t>(ray.kz);
    ShearedRay in_order = ray;  // For corners whose coordinates are in the order of the ray.
    in_order.kx = 0;
    in_order.ky = 1;
    in_order.kz = 2;
    for (size_t i = 0; i < count; ++i) {
      const Vec2 a = in_order.Shear({block[kx][i], block[ky][i], block[kz][i]});
      const Vec2 b = in_order.Shear({block[3 + kx][i], block[3 + ky][i], block[3 + kz][i]});
      const Vec2 c = in_order.Shear({block[6 + kx][i], block[6 + ky][i], block[6 + kz][i]});
      const EdgeAreas areas = {c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x};
      (*may_hit)[i] = !areas.AreMixed();
    }
  }

  size_t count_, steps_;
  std::vector<float> numbers_;
};

/// The inverse at a time, unless there is none.
std::optional<Transform> GroupFromWorld(const std::vector<Mat4>& steps, float time) {
  Mat4 matrix = steps[0];
  if (steps.size() > 1) {
    const double position = static_cast<double>(time) * static_cast<double>(steps.size() - 1);
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
  return inverse ? std::optional(Transform(*inverse)) : std::nullopt;
}

}  // namespace

/// A group with what does not depend on the ray.
struct FullSearch::Prepared {
  struct Item {
    const GroupDescription::Item* described;
    std::optional<TriangleRows> triangles;
    const Prepared* inner = nullptr;            ///< Of an instance.
    std::optional<Transform> group_from_world;  ///< Of one at rest.
  };
  std::vector<Item> items;
};

/// The search for the nearest hit of one ray.
class FullSearch::Query {
 public:
  Query(const Ray& asked, HitRecord* hit) : asked_(asked), hit_(hit) {}

  void Visit(const Prepared& group, const Ray& ray) {
    const float length = LengthSquared(ray.direction);
    if (!(length > 0 && std::isfinite(length) && IsFinite(ray.origin) && ray.t_min >= 0)) return;
    path_.push_back(0);
    for (const Prepared::Item& item : group.items) {
      if ((item.described->mask & asked_.mask) != 0) VisitItem(item, ray);
      ++path_.back();
    }
    path_.pop_back();
  }

 private:
  void VisitItem(const Prepared::Item& item, const Ray& ray) {
    const auto& content = item.described->content;
    if (item.triangles) VisitTriangles(item, ray);
    if (const auto* set = std::get_if<2>(&content)) VisitSet(*item.described, **set, ray);
    if (const auto* instance = std::get_if<3>(&content)) VisitInstance(item, *instance, ray);
  }

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

  void VisitTriangles(const Prepared::Item& item, const Ray& ray) {
    const ShearedRay sheared(ray);
    item.triangles->ForEachCandidate(sheared, ray.time, [&](uint32_t i, Vec3 a, Vec3 b, Vec3 c) {
      HitRecord found = Limit();
      if (IntersectTriangle(sheared, ray.t_min, a, b, c, &found)) Offer(*item.described, i, found);
    });
  }

  void VisitSet(const GroupDescription::Item& item, const PrimitiveSet& set, const Ray& ray) {
    for (uint32_t i = 0; i < set.PrimitiveCount(); ++i) {
      HitRecord found = Limit();
      if (set.IntersectPrimitive(ray, i, &found)) Offer(item, i, found);
    }
  }

  void VisitInstance(const Prepared::Item& item, const GroupDescription::Instance& instance,
                     const Ray& ray) {
    const bool is_moving = instance.world_from_group.size() > 1;
    const std::optional<Transform> group_from_world =
        is_moving ? GroupFromWorld(instance.world_from_group, ray.time) : item.group_from_world;
    if (!group_from_world) return;
    Ray inner = ray;
    inner.origin = group_from_world->Point(ray.origin);
    inner.direction = group_from_world->Vector(ray.direction);
    Visit(*item.inner, inner);
  }

  const Ray& asked_;
  HitRecord* hit_;
  std::vector<uint32_t> path_;
};

FullSearch::FullSearch(const GroupDescription& group) : outermost_(Prepare(group)) {}

FullSearch::~FullSearch() = default;

const FullSearch::Prepared* FullSearch::Prepare(const GroupDescription& group) {
  std::unique_ptr<Prepared>& prepared = prepared_[&group];
  if (prepared) return prepared.get();
  prepared = std::make_unique<Prepared>();
  for (const GroupDescription::Item& described : group.items) {
    Prepared::Item item{&described, {}, nullptr, {}};
    if (const auto* mesh = std::get_if<1>(&described.content)) item.triangles.emplace(**mesh);
    if (const auto* instance = std::get_if<3>(&described.content)) {
      item.inner = Prepare(*instance->group);
      item.group_from_world = GroupFromWorld(instance->world_from_group, 0);
    }
    prepared->items.push_back(std::move(item));
  }
  return prepared.get();
}

bool FullSearch::Intersect(const Ray& ray, HitRecord* hit) const {
  Ray clamped = ray;
  if (!(clamped.time >= 0)) clamped.time = 0;  // NaN too.
  if (clamped.time > 1) clamped.time = 1;
  HitRecord nearest = *hit;
  nearest.object = HitRecord::kNone;
  Query(ray, &nearest).Visit(*outermost_, clamped);
  if (!nearest.IsHit()) return false;
  *hit = nearest;
  return true;
}

}  // namespace candela::test
