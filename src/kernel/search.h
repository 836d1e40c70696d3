#pragma once

#include <bit>
#include <limits>

#include "geometry/hit_record.h"
#include "kernel/child_order.h"
#include "kernel/group.h"
#include "kernel/group_data.h"
#include "kernel/node_stack.h"
#include "kernel/space_ray.h"

namespace candela::kernel {

/// The next smaller float of a positive one; what is not positive, or not a number, gives a number
/// below 0, before which there are no hits.
template <class L>
float JustBelow(float t) {
  if (!(t > 0)) return -1;
  return std::bit_cast<float>(std::bit_cast<uint32_t>(t) - 1);
}
template <class L>
float JustAbove(float t) {
  return std::bit_cast<float>(std::bit_cast<uint32_t>(t + 0.0f) + 1);
}

/// The nearest hit of a search so far, and what decides between hits at the same distance.
struct Nearest {
  float t;  ///< Hits up to here, included, are of interest.
  float u, v;
  uint32_t item;                          ///< HitRecord::kNone: there is none.
  const uint32_t* primitive;              ///< Where its index is: read only when it is needed.
  int level;                              ///< Groups that were entered on the way to it.
  uint32_t path[HitRecord::kMostNested];  ///< The items of those groups, outermost first.

  /// As it is reported.
  [[gnu::always_inline]] void Store(HitRecord* hit) const {
    hit->t = t;
    hit->u = u;
    hit->v = v;
    hit->object = item;
    hit->primitive = *primitive;
    for (uint32_t& inner : hit->nested) inner = HitRecord::kNone;
    if (level == 0) [[likely]]
      return;
    hit->object = path[0];
    for (int i = 1; i < level; ++i) hit->nested[i - 1] = path[i];
    hit->nested[level - 1] = item;
  }
};

/// A group that a search has left for one inside, and the ray in its space.
struct OuterGroup {
  const GroupData* group;
  SpaceRay space;
};

/// Memory that a search rarely uses much of. Apart from it, so that many searches stand close
/// together; not initialised, since a search may be shorter than that.
struct SearchRoom {
  SearchRoom() {}

  StackEntry entry[kMostStack];
  union {
    OuterGroup outer[HitRecord::kMostNested];
  };
};

/// One ray on its way through a group and the groups inside. Invariants:
/// - Everything that may hold a hit not farther than `nearest.t` is the current reference, on the
///   stack, or below something there.
/// - A box is left out only when its entry lies beyond `nearest.t`, or it is missed. A hit found in
///   a leaf counts at the entry of the leaf's box at least. (Of a triangle that was split, the
///   piece that is met has the nearest.) So a hit is never lost because another one was found
///   earlier, whatever rounding did to their distances, and the answer does not depend on the order
///   of visits.
/// - References on the stack above the mark of a level belong to the group of that level.
template <class L>
struct Search {
  static constexpr int kWidth = L::kWidth;

  const Ray* asked;        ///< As it came, in the space of the outermost group.
  const GroupData* group;  ///< The one that is being searched,
  const Record* records;   ///< its records,
  SpaceRay space;          ///< and the ray in its space; of the outermost one set when needed.
  float t_min;
  Nearest nearest;
  NextChild current;  ///< What is looked at next, when many rays take turns.
  int level = 0;
  uint32_t path[HitRecord::kMostNested];
  NodeStack stack;
  OuterGroup* outer;

  /// Prepares the ray for the boxes and triangles of the outermost group.
  [[gnu::always_inline]] void PrepareOutermost() {
    space.Set<L>(asked->origin, asked->direction, t_min, group->largest_coordinate);
  }

  /// The ray in the space of the current group.
  Ray CurrentRay() const {
    Ray ray = level == 0 ? Ray(asked->origin, asked->direction)
                         : Ray(space.sheared.origin, space.sheared.direction);
    ray.t_min = t_min;
    ray.t_max = asked->t_max;
    ray.time = Time();
    ray.mask = asked->mask;
    return ray;
  }

  /// Its time, in [0, 1]; 0 when it is not a number.
  float Time() const {
    const float time = asked->time;
    return !(time > 0) ? 0 : time < 1 ? time : 1;
  }

  /// Starts outside of all groups. False when the ray cannot hit anything. `room` is the search's
  /// own until it ends.
  [[gnu::always_inline]] bool Begin(const GroupData& outermost, const Ray& ray, float t_limit,
                                    SearchRoom* room) {
    asked = &ray;
    nearest.t = JustBelow<L>(t_limit);
    nearest.item = HitRecord::kNone;
    if (!(ray.t_min >= 0 && ray.t_min <= nearest.t)) return false;
    level = 0;
    stack = {0, room->entry};
    outer = room->outer;
    if (!IsTraceable<L>(ray.origin, ray.direction)) return false;
    group = &outermost;
    records = group->records.data();
    t_min = ray.t_min + 0.0f;  // Turns -0 into 0, whose bits are ordered like the others.
    return true;
  }

  /// Whether the ray's mask lets it see an item of the current group.
  bool Sees(uint32_t item) const { return (group->items[item].mask & asked->mask) != 0; }

  bool HasHit() const { return nearest.item != HitRecord::kNone; }

  /// Whether a hit at the distance of the nearest one wins by its indices.
  bool WinsTie(uint32_t item, uint32_t primitive) const {
    const int depth = nearest.level < level ? nearest.level : level;
    for (int i = 0; i < depth; ++i) {
      if (path[i] != nearest.path[i]) return path[i] < nearest.path[i];
    }
    // Where one is in a group of which the other is a neighbour, their items there differ.
    const uint32_t mine = depth < level ? path[depth] : item;
    const uint32_t other = depth < nearest.level ? nearest.path[depth] : nearest.item;
    if (mine != other) return mine < other;
    return primitive < *nearest.primitive;
  }

  /// The distance at which a hit at `t` in a leaf that the ray enters at `entry` counts; a miss
  /// when it lies before the ray's beginning or beyond the nearest hit.
  bool Counts(float entry, float* t) const {
    if (!(*t >= t_min)) return false;  // NaN is a miss.
    if (*t < entry) *t = entry;
    return *t <= nearest.t;
  }

  /// Takes a hit that counts unless the nearest one is as near and wins. `primitive` has to stay
  /// where it is.
  bool Offer(float t, float u, float v, uint32_t item, const uint32_t* primitive) {
    if (t == nearest.t && HasHit() && !WinsTie(item, *primitive)) return false;
    nearest.t = t;
    nearest.u = u;
    nearest.v = v;
    nearest.item = item;
    nearest.primitive = primitive;
    nearest.level = level;
    for (int i = 0; i < level; ++i) nearest.path[i] = path[i];
    __builtin_prefetch(primitive);
    return true;
  }

  /// Whether the filter of an item lets a hit count.
  bool PassesFilter(const ItemFacts& facts, float t, float u, float v, uint32_t item,
                    const uint32_t* primitive) const {
    if (!facts.filter) return true;
    Nearest candidate{t, u, v, item, primitive, level, {}};
    for (int i = 0; i < level; ++i) candidate.path[i] = path[i];
    HitRecord hit;
    candidate.Store(&hit);
    return facts.filter->Accepts(*asked, hit);
  }

  [[gnu::always_inline]] bool Report(HitRecord* hit) const {
    if (!HasHit()) return false;
    nearest.Store(hit);
    return true;
  }
};

}  // namespace candela::kernel
