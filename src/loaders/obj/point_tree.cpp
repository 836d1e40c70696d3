#include "loaders/obj/point_tree.h"

#include <algorithm>
#include <limits>

namespace candela {
namespace {

constexpr uint32_t kGone = std::numeric_limits<uint32_t>::max();
constexpr uint32_t kLeafSize = 8;

Vec2 Lower(Vec2 a, Vec2 b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y)};
}

Vec2 Upper(Vec2 a, Vec2 b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y)};
}

/// True when all of the box lies strictly to the right of the line from `a` to `b`: even its corner
/// farthest to the left does. Rounding is monotonic, so this never excludes a point that `Orient`
/// itself would place on the left.
bool IsRightOf(Vec2 low, Vec2 high, Vec2 a, Vec2 b) {
  const Vec2 leftmost = {b.y < a.y ? high.x : low.x, b.x > a.x ? high.y : low.y};
  return Orient(a, b, leftmost) < 0;
}

}  // namespace

double Orient(Vec2 a, Vec2 b, Vec2 c) {
  const double abx = double{b.x} - a.x, aby = double{b.y} - a.y;
  const double acx = double{c.x} - a.x, acy = double{c.y} - a.y;
  return abx * acy - aby * acx;
}

void PointTree::Build(std::span<const Vec2> points, std::span<const uint32_t> members) {
  points_ = points;
  nodes_.clear();
  order_.assign(members.begin(), members.end());
  if (!order_.empty()) BuildNode(0, static_cast<uint32_t>(order_.size()));
  slots_.assign(points.size(), kGone);
  for (uint32_t slot = 0; slot < order_.size(); ++slot) slots_[order_[slot]] = slot;
}

uint32_t PointTree::BuildNode(uint32_t begin, uint32_t end) {
  Node node{points_[order_[begin]], points_[order_[begin]], begin, end, end - begin, 0};
  for (uint32_t slot = begin; slot < end; ++slot) {
    node.low = Lower(node.low, points_[order_[slot]]);
    node.high = Upper(node.high, points_[order_[slot]]);
  }
  const auto index = static_cast<uint32_t>(nodes_.size());
  nodes_.push_back(node);
  if (end - begin <= kLeafSize) return index;

  const bool along_x = double{node.high.x} - node.low.x > double{node.high.y} - node.low.y;
  const uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](uint32_t a, uint32_t b) {
                     return along_x ? points_[a].x < points_[b].x : points_[a].y < points_[b].y;
                   });
  BuildNode(begin, middle);
  const uint32_t second = BuildNode(middle, end);
  nodes_[index].second = second;
  return index;
}

void PointTree::Remove(uint32_t point) {
  const uint32_t slot = slots_[point];
  if (slot == kGone) return;
  slots_[point] = kGone;
  for (uint32_t index = 0;;) {
    Node& node = nodes_[index];
    --node.left;
    if (node.second == 0) return;
    index = slot < nodes_[node.second].begin ? index + 1 : node.second;
  }
}

bool PointTree::HasPointIn(Vec2 a, Vec2 b, Vec2 c) const {
  if (nodes_.empty()) return false;
  return Search({a, b, c, Lower(Lower(a, b), c), Upper(Upper(a, b), c)}, 0);
}

bool PointTree::Search(const Triangle& triangle, uint32_t index) const {
  const Node& node = nodes_[index];
  const Vec2 a = triangle.a, b = triangle.b, c = triangle.c;
  const Vec2 low = triangle.low, high = triangle.high;
  if (node.left == 0) return false;
  if (node.low.x > high.x || node.high.x < low.x || node.low.y > high.y || node.high.y < low.y) {
    return false;
  }
  if (IsRightOf(node.low, node.high, a, b) || IsRightOf(node.low, node.high, b, c) ||
      IsRightOf(node.low, node.high, c, a)) {
    return false;
  }
  const auto is_corner = [&](Vec2 p) { return p == a || p == b || p == c; };
  // A file may repeat a corner a million times; all of them are left aside at once.
  if (node.low == node.high && is_corner(node.low)) return false;
  if (node.second != 0) return Search(triangle, index + 1) || Search(triangle, node.second);

  for (uint32_t slot = node.begin; slot < node.end; ++slot) {
    const uint32_t point = order_[slot];
    if (slots_[point] == kGone) continue;
    const Vec2 p = points_[point];
    if (Orient(a, b, p) >= 0 && Orient(b, c, p) >= 0 && Orient(c, a, p) >= 0 && !is_corner(p)) {
      return true;
    }
  }
  return false;
}

}  // namespace candela
