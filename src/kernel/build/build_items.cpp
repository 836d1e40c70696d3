#include "kernel/build/build_items.h"

#include <algorithm>
#include <limits>

#include "kernel/group.h"
#include "math/transform.h"

namespace candela::kernel {
namespace {

bool IsFinite4(Float4 a) {
  // A difference of two infinities, or with a NaN, is a NaN; that of two numbers is 0.
  const Float4 zero = a - a;
  return zero[0] == 0 && zero[1] == 0 && zero[2] == 0;
}

/// Exactly no area, in double. Of corners that coincide, and most that lie on a line.
bool HasNoArea(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3d origin = ToDouble(a);
  return Cross(ToDouble(b) - origin, ToDouble(c) - origin) == Vec3d{};
}

BoxState StateOf(const Bounds3& bounds) {
  if (bounds.IsFinite()) return bounds.IsEmpty() ? BoxState::kNothing : BoxState::kBox;
  // A NaN makes it empty; of the others only those that contain something have no bounds.
  return bounds.IsEmpty() ? BoxState::kNothing : BoxState::kUnbounded;
}

float LargestMagnitude(const Box4& box) {
  return LargestOf3(Max(Abs(box.low), Abs(box.high)));
}

/// The box at a time step.
BoxState BoxAtStep(const BuildItem& item, uint32_t primitive, uint32_t step, Box4* box) {
  if (item.triangles) {
    Box4 around;
    for (const uint32_t vertex : item.triangles->triangles[primitive]) {
      const Float4 position = ToFloat4(item.Position(step, vertex));
      if (!IsFinite4(position)) return BoxState::kNothing;
      around.Extend(position);
    }
    *box = Padded(around, kTrianglePadding * LargestOf3(around.high - around.low));
    return BoxState::kBox;
  }
  Bounds3 bounds;
  if (item.set) {
    bounds = item.set->PrimitiveBounds(primitive, step);
  } else {
    const Group& inner = *item.instance->group;
    if (inner.HasUnbounded()) return BoxState::kUnbounded;
    bounds = TransformBounds(Transform(item.instance->world_from_group[step]), inner.Bounds());
  }
  *box = Box4::Of(bounds);
  return StateOf(bounds);
}

}  // namespace

std::vector<BuildItem> MakeBuildItems(const GroupInput& input) {
  std::vector<BuildItem> items;
  items.reserve(input.size());
  for (const GroupItem& from : input) {
    BuildItem& item = items.emplace_back();
    if (const auto* triangles = std::get_if<TriangleInput>(&from.content)) {
      item.triangles = triangles;
      item.count = static_cast<uint32_t>(triangles->triangles.size());
      item.steps = triangles->steps;
      item.vertex_count = triangles->positions.size() / std::max(1u, triangles->steps);
      item.may_weld = item.steps == 1 && item.vertex_count >= item.count;
      item.may_split = item.steps == 1 && !from.filter;
      const bool is_plain = item.steps == 1 && from.mask == kAnyRay && !from.filter;
      item.leaf = is_plain ? RecordKind::kTriangles : RecordKind::kCheckedTriangles;
    } else if (const auto* primitives = std::get_if<PrimitiveInput>(&from.content)) {
      item.set = primitives->set;
      item.count = item.set->PrimitiveCount();
      item.steps = item.set->TimeSteps();
      item.leaf = RecordKind::kPrimitives;
    } else if (const auto* instance = std::get_if<InstanceInput>(&from.content)) {
      item.instance = instance;
      item.count = 1;
      item.steps = static_cast<uint32_t>(instance->world_from_group.size());
      item.leaf = RecordKind::kInstance;
    }
  }
  return items;
}

Result<void> CheckInstance(const GroupItem& item, const InstanceInput& instance,
                           const GroupData& group) {
  const char* problem = nullptr;
  if (!instance.group) {
    problem = "an instance needs a group";
  } else if (instance.group->data().width != group.width) {
    problem = "a group and those that it has instances of need nodes of the same width";
  } else if (instance.group->data().accelerator != group.accelerator) {
    problem = "a group and those that it has instances of need the same accelerator";
  } else if (instance.world_from_group.empty() ||
             !InverseAffine(instance.world_from_group.front())) {
    problem = "an instance needs matrices, the first of them with an inverse";
  } else if (item.filter) {
    problem = "an instance cannot have a filter; the items of its group can";
  }
  return problem ? Result<void>(Error{ErrorCode::kUsage, problem}) : Result<void>();
}

Box4 Padded(const Box4& box, float padding) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  constexpr float kUlp = std::numeric_limits<float>::epsilon();
  const Float4 low = box.low - Broadcast(padding), high = box.high + Broadcast(padding);
  return {Max(low - Abs(low) * Broadcast(kUlp), Broadcast(-kLargest)),
          Min(high + Abs(high) * Broadcast(kUlp), Broadcast(kLargest))};
}

BoxState BoxOfTriangle(const BuildItem& item, uint32_t triangle, Box4* box) {
  const auto& vertices = item.triangles->triangles[triangle];
  const Vec3* positions = item.triangles->positions.data();
  const Vec3 p0 = positions[vertices[0]], p1 = positions[vertices[1]], p2 = positions[vertices[2]];
  const Float4 a = ToFloat4(p0), b = ToFloat4(p1), c = ToFloat4(p2);
  const Box4 around{Min(Min(a, b), c), Max(Max(a, b), c)};
  // Quarters, whose sum is a number if all three are.
  if (!IsFinite4(a * Broadcast(0.25f) + b * Broadcast(0.25f) + c * Broadcast(0.25f)) ||
      HasNoArea(p0, p1, p2)) {
    return BoxState::kNothing;
  }
  *box = Padded(around, kTrianglePadding * LargestOf3(around.high - around.low));
  return BoxState::kBox;
}

BoxState BoxOf(const BuildItem& item, uint32_t primitive, Box4* box) {
  return item.triangles ? BoxOfTriangle(item, primitive, box) : BoxAtStep(item, primitive, 0, box);
}

BoxState LinearBoxOf(const BuildItem& item, uint32_t primitive, LinearBox* box) {
  const uint32_t last = item.steps - 1;
  Box4 steps_ends[2];
  for (uint32_t step = 0; step <= last; ++step) {
    Box4 at_step;
    const BoxState state = BoxAtStep(item, primitive, step, &at_step);
    if (state != BoxState::kBox) return state;
    if (step == 0) steps_ends[0] = at_step;
    if (step == last) steps_ends[1] = at_step;
  }
  // Between the first and the last step a box may leave the straight way. Both ends are widened by
  // as much as it does at most; then each box is inside, and so is what lies between two of them.
  Float4 below = Broadcast(0), above = Broadcast(0);
  float magnitude = std::max(LargestMagnitude(steps_ends[0]), LargestMagnitude(steps_ends[1]));
  for (uint32_t step = 1; step < last; ++step) {
    Box4 at_step;
    BoxAtStep(item, primitive, step, &at_step);
    const float part = static_cast<float>(step) / static_cast<float>(last);
    const Float4 t1 = Broadcast(part), t0 = Broadcast(1 - part);
    below = Max(below, steps_ends[0].low * t0 + steps_ends[1].low * t1 - at_step.low);
    above = Max(above, at_step.high - (steps_ends[0].high * t0 + steps_ends[1].high * t1));
    magnitude = std::max(magnitude, LargestMagnitude(at_step));
  }
  // The second part covers the rounding above, and that of a search which puts boxes and vertices
  // between two steps.
  const float rounding = magnitude * 1e-6f;
  for (int end = 0; end < 2; ++end) {
    box->at[end] = Padded({steps_ends[end].low - below, steps_ends[end].high + above}, rounding);
  }
  return BoxState::kBox;
}

}  // namespace candela::kernel
