#pragma once

#include "kernel/record.h"
#include "kernel/space_ray.h"

namespace candela::kernel {

/// The constants of the box test, each in all lanes.
template <class F>
struct WideSlabs {
  F near_scale[3], near_offset[3], far_scale[3], far_offset[3], t_min;

  [[gnu::always_inline]] explicit WideSlabs(const Slabs& slabs) : t_min(F::Broadcast(slabs.t_min)) {
    for (int axis = 0; axis < 3; ++axis) {
      near_scale[axis] = F::Broadcast(slabs.near_scale[axis]);
      near_offset[axis] = F::Broadcast(slabs.near_offset[axis]);
      far_scale[axis] = F::Broadcast(slabs.far_scale[axis]);
      far_offset[axis] = F::Broadcast(slabs.far_offset[axis]);
    }
  }
};

/// Which boxes of a node a ray meets between t_min and a limit, both included, and where it enters
/// them.
template <class F>
struct BoxHits {
  typename F::Mask mask;
  F entry;
};

/// The slab test of Kay and Kajiya, "Ray Tracing Complex Scenes", 1986, for all children at once.
/// `plane(axis, row)` gives the planes of a row.
template <class F, class Plane>
[[gnu::always_inline]] inline BoxHits<F> TestSlabs(const WideSlabs<F>& wide, const Slabs& slabs,
                                                   F limit, Plane plane) {
  F enter[3], leave[3];
  for (int axis = 0; axis < 3; ++axis) {
    const uint32_t near_row = slabs.near_row[axis];
    enter[axis] = FusedSubtract(plane(near_row), wide.near_scale[axis], wide.near_offset[axis]);
    leave[axis] = FusedSubtract(plane(near_row ^ 1), wide.far_scale[axis], wide.far_offset[axis]);
  }
  const F entry = Max(Max(enter[0], enter[1]), Max(enter[2], wide.t_min));
  const F exit = Min(Min(leave[0], leave[1]), Min(leave[2], limit));
  return {entry <= exit, entry};
}

template <class F, int W>
[[gnu::always_inline]] inline BoxHits<F> TestBoxes(const WideSlabs<F>& wide, const Slabs& slabs,
                                                   const WideNode<W>& node, F limit) {
  return TestSlabs(wide, slabs, limit, [&](uint32_t row) { return F::Load(node.box[row]); });
}

/// The boxes of a moving node at the ray's time. The ends of the time are left out, less than the
/// builder's padding of moving boxes: the boxes of children that are not there are infinite, and 0
/// times infinity is not a number, which would let them pass.
template <class F, int W>
[[gnu::always_inline]] inline BoxHits<F> TestBoxes(const WideSlabs<F>& wide, const Slabs& slabs,
                                                   const MovingNode<W>& node, F limit, float time) {
  const float inner = time < 1e-30f ? 1e-30f : time < 0x1.fffffep-1f ? time : 0x1.fffffep-1f;
  const F before = F::Broadcast(1 - inner), after = F::Broadcast(inner);
  return TestSlabs(wide, slabs, limit, [&](uint32_t row) {
    return F::Load(node.box[0][row]) * before + F::Load(node.box[1][row]) * after;
  });
}

}  // namespace candela::kernel
