#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "base/parallel.h"
#include "kernel/build/fragment.h"

namespace candela::kernel {

/// Large ranges are worked on by all threads, a chunk at a time.
constexpr uint32_t kChunkSize = 16384;

/// Calls `body(chunk, begin, end, worker)` for each chunk of `count` things.
template <class Body>
void ForEachChunk(uint32_t count, const Body& body) {
  const uint32_t chunks = (count + kChunkSize - 1) / kChunkSize;
  ParallelForWorkers(chunks, [&](int64_t i, int worker) {
    const auto chunk = static_cast<uint32_t>(i);
    body(chunk, chunk * kChunkSize, std::min(count, (chunk + 1) * kChunkSize), worker);
  });
}

/// Brings the fragments for which `is_left` holds to the front and returns their number. Without
/// branches, which no processor would guess right. `scratch` has room for all of them.
template <class IsLeft>
uint32_t Partition(Fragment* begin, Fragment* end, Fragment* scratch, const IsLeft& is_left) {
  Fragment* left = begin;
  Fragment* right = scratch;
  for (Fragment* from = begin; from != end; ++from) {
    const Fragment fragment = *from;
    const bool goes_left = is_left(fragment);
    *left = fragment;
    *right = fragment;
    left += goes_left ? 1 : 0;
    right += goes_left ? 0 : 1;
  }
  std::copy(scratch, right, left);
  return static_cast<uint32_t>(left - begin);
}

/// The same for a large range, on all threads: chunk by chunk first; then what stands on the wrong
/// side of the border changes places. `scratch` has a chunk for each thread.
template <class IsLeft>
uint32_t PartitionParallel(Fragment* begin, uint32_t count,
                           std::vector<PageArray<Fragment>>& scratch, const IsLeft& is_left) {
  struct Stretch {
    uint32_t begin, end;
  };
  std::vector<uint32_t> left_counts((count + kChunkSize - 1) / kChunkSize);
  ForEachChunk(count, [&](uint32_t chunk, uint32_t from, uint32_t to, int worker) {
    left_counts[chunk] =
        Partition(begin + from, begin + to, scratch[static_cast<size_t>(worker)].data(), is_left);
  });
  uint32_t border = 0;
  for (const uint32_t left_count : left_counts) border += left_count;

  std::vector<Stretch> rights_before, lefts_behind;  // What has to change places.
  for (uint32_t chunk = 0; chunk < left_counts.size(); ++chunk) {
    const uint32_t from = chunk * kChunkSize, middle = from + left_counts[chunk];
    const uint32_t to = std::min(count, from + kChunkSize);
    if (middle < border) rights_before.push_back({middle, std::min(to, border)});
    if (middle > border) lefts_behind.push_back({std::max(from, border), middle});
  }
  struct Exchange {
    uint32_t a, b, count;
  };
  std::vector<Exchange> exchanges;
  for (size_t i = 0, j = 0; i < rights_before.size() && j < lefts_behind.size();) {
    Stretch& a = rights_before[i];
    Stretch& b = lefts_behind[j];
    const uint32_t both = std::min(a.end - a.begin, b.end - b.begin);
    if (both > 0) exchanges.push_back({a.begin, b.begin, both});
    a.begin += both;
    b.begin += both;
    if (a.begin == a.end) ++i;
    if (b.begin == b.end) ++j;
  }
  ParallelFor(static_cast<int64_t>(exchanges.size()), [&](int64_t i) {
    const Exchange& exchange = exchanges[static_cast<size_t>(i)];
    std::swap_ranges(begin + exchange.a, begin + exchange.a + exchange.count, begin + exchange.b);
  });
  return border;
}

}  // namespace candela::kernel
