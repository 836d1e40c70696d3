#include <algorithm>
#include <cstring>

#include "base/parallel.h"
#include "kernel/build/fragment.h"

namespace candela::kernel {
namespace {

constexpr uint64_t kChunk = 16384;

/// What one chunk of the primitives gave.
struct Chunk {
  uint32_t count = 0;
  Box4 box, centers;
  Bounds3 bounds;
  std::vector<FragmentList::Unbounded> unbounded;

  void Add(const Fragment& fragment) {
    box.Extend(fragment.Box());
    const Float4 center = fragment.Center();
    centers.Extend(center);
    ++count;
  }
};

/// Fragments of primitives [begin, end) of an item, from `to` on.
void CollectRange(const BuildItem& item, uint32_t number, uint32_t begin, uint32_t end,
                  Fragment* to, Chunk* chunk) {
  for (uint32_t i = begin; i < end; ++i) {
    Box4 box;
    LinearBox moving;
    const BoxState state = item.IsMoving() ? LinearBoxOf(item, i, &moving) : BoxOf(item, i, &box);
    if (state == BoxState::kUnbounded) chunk->unbounded.push_back({number, i});
    if (state != BoxState::kBox) continue;
    if (item.IsMoving()) {
      box = moving.Middle();
      chunk->bounds.Extend(moving.at[0].ToBounds());
      chunk->bounds.Extend(moving.at[1].ToBounds());
    }
    const Fragment fragment(box, number, i);
    to[chunk->count] = fragment;
    chunk->Add(fragment);
  }
}

/// The same, without a question per triangle.
void CollectTriangles(const BuildItem& item, uint32_t number, uint32_t begin, uint32_t end,
                      Fragment* to, Chunk* chunk) {
  for (uint32_t i = begin; i < end; ++i) {
    Box4 box;
    if (BoxOfTriangle(item, i, &box) != BoxState::kBox) continue;
    const Fragment fragment(box, number, i);
    to[chunk->count] = fragment;
    chunk->Add(fragment);
  }
}

}  // namespace

FragmentList CollectFragments(const std::vector<BuildItem>& items, bool moving, double growth,
                              const CancelToken* cancel) {
  // Primitives are numbered through: item i has those from starts[i] on.
  std::vector<uint64_t> starts(items.size() + 1, 0);
  for (size_t i = 0; i < items.size(); ++i) {
    starts[i + 1] = starts[i] + (items[i].IsMoving() == moving ? items[i].count : 0);
  }
  const uint64_t total = starts.back();
  FragmentList list;
  if (total == 0) return list;
  list.capacity = static_cast<uint32_t>(static_cast<double>(total) * growth);
  list.fragments = PageArray<Fragment>(list.capacity);

  std::vector<Chunk> chunks((total + kChunk - 1) / kChunk);
  ParallelFor(static_cast<int64_t>(chunks.size()), [&](int64_t number) {
    StopWhenCancelled(cancel);
    uint64_t at = static_cast<uint64_t>(number) * kChunk;
    const uint64_t end = std::min(at + kChunk, total);
    Fragment* const to = list.fragments.data() + at;
    Chunk chunk;
    size_t item = static_cast<size_t>(std::upper_bound(starts.begin(), starts.end(), at) -
                                      starts.begin() - 1);
    for (; at < end; ++item) {
      const uint64_t item_end = std::min(end, starts[item + 1]);
      if (item_end == at) continue;
      const auto first = static_cast<uint32_t>(at - starts[item]);
      const auto last = static_cast<uint32_t>(item_end - starts[item]);
      const bool is_plain = items[item].triangles && !moving;
      (is_plain ? CollectTriangles : CollectRange)(items[item], static_cast<uint32_t>(item), first,
                                                   last, to, &chunk);
      at = item_end;
    }
    chunks[static_cast<size_t>(number)] = std::move(chunk);
  });

  // Close the gaps that left out primitives make.
  for (size_t i = 0; i < chunks.size(); ++i) {
    const Fragment* const from = list.fragments.data() + i * kChunk;
    Fragment* const to = list.fragments.data() + list.count;
    if (from != to) std::copy(from, from + chunks[i].count, to);
    list.count += chunks[i].count;
    list.box.Extend(chunks[i].box);
    list.centers.Extend(chunks[i].centers);
    list.bounds.Extend(chunks[i].bounds);
    list.unbounded.insert(list.unbounded.end(), chunks[i].unbounded.begin(),
                          chunks[i].unbounded.end());
  }
  if (!moving && list.count > 0) list.bounds = list.box.ToBounds();
  return list;
}

}  // namespace candela::kernel
