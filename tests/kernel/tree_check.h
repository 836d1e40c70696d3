#pragma once

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "kernel/group_data.h"
#include "kernel/group_input.h"
#include "kernel/record.h"

/// Walks a whole tree and collects what is wrong with it.
namespace candela::kernel::testing_support {

class TreeCheck {
 public:
  /// `whole_triangles`: none was split, so its padded box lies in all boxes above.
  TreeCheck(const GroupInput& input, const GroupData& group, bool whole_triangles)
      : input_(input), group_(group), whole_triangles_(whole_triangles) {
    if (group.root != GroupData::kNothing) {
      Box whole[2] = {Box::Everything(), Box::Everything()};
      const Facts facts = Walk(group.root, whole, 0);
      Expect(facts.depth == group.depth, "depth");
      Expect(facts.need + group.entries.size() == group.stack_need, "stack_need");
      Expect(facts.tree_need <= kMostTreeStack, "the stack of the tree");
    }
  }

  std::string Problems() const { return problems_; }
  /// How often each (item, primitive) stands in a leaf.
  const std::map<std::pair<uint32_t, uint32_t>, int>& Found() const { return found_; }
  /// Sorted contents of each leaf, with the box over it.
  const std::multiset<std::vector<float>>& Leaves() const { return leaves_; }
  size_t TriangleLeaves() const { return triangle_leaves_; }
  size_t Nodes() const { return nodes_; }

 private:
  struct Box {
    float low[3], high[3];
    static Box Everything() {
      constexpr float kInf = Bounds3::kInfinity;
      return {{-kInf, -kInf, -kInf}, {kInf, kInf, kInf}};
    }
    bool Contains(const Box& other) const {
      for (int a = 0; a < 3; ++a) {
        if (!(low[a] <= other.low[a] && other.high[a] <= high[a])) return false;
      }
      return true;
    }
    bool Contains(Vec3 p) const { return Contains(Box{{p.x, p.y, p.z}, {p.x, p.y, p.z}}); }
    bool Meets(const Box& other) const {
      for (int a = 0; a < 3; ++a) {
        if (!(low[a] <= other.high[a] && other.low[a] <= high[a])) return false;
      }
      return true;
    }
  };
  struct Facts {
    int depth = 0;
    uint32_t tree_need = 0, need = 0;
  };

  void Expect(bool holds, const std::string& what) {
    if (!holds && problems_.size() < 1000) problems_ += "wrong: " + what + "\n";
  }

  Facts Walk(Reference reference, const Box (&box)[2], uint32_t parent) {
    const uint32_t record = RecordOf(reference);
    Expect(record < group_.records.size(), "record number");
    Expect(reference == group_.root || record > parent, "children come after their parent");
    switch (KindOf(reference)) {
      case RecordKind::kNode:
        return group_.width == 8 ? WalkNode<WideNode<8>, 8>(reference, box)
                                 : WalkNode<WideNode<16>, 16>(reference, box);
      case RecordKind::kMovingNode:
        return group_.width == 8 ? WalkNode<MovingNode<8>, 8>(reference, box)
                                 : WalkNode<MovingNode<16>, 16>(reference, box);
      case RecordKind::kTriangles:
      case RecordKind::kCheckedTriangles:
        return CheckTriangles(reference, box), Facts{};
      case RecordKind::kPrimitives:
        return CheckPrimitives(reference, box), Facts{};
      case RecordKind::kInstance: {
        const auto& leaf = *reinterpret_cast<const InstanceLeaf*>(&group_.records.data()[record]);
        ++found_[{leaf.item, 0}];
        return {0, 0, 1 + group_.items[leaf.item].group->data().stack_need};
      }
      default:
        Expect(false, "kind");
        return {};
    }
  }

  template <int W>
  static const float* Row(const WideNode<W>& node, int, int row) {
    return node.box[row];
  }
  template <int W>
  static const float* Row(const MovingNode<W>& node, int end, int row) {
    return node.box[end][row];
  }

  template <class Node, int kWidth>
  Facts WalkNode(Reference reference, const Box (&box)[2]) {
    ++nodes_;
    const auto& node = *reinterpret_cast<const Node*>(&group_.records.data()[RecordOf(reference)]);
    Facts facts;
    uint32_t count = 0;
    for (int i = 0; i < kWidth; ++i) {
      Box child[2];
      for (int end = 0; end < 2; ++end) {
        for (int axis = 0; axis < 3; ++axis) {
          child[end].low[axis] = Row(node, end, 2 * axis)[i];
          child[end].high[axis] = Row(node, end, 2 * axis + 1)[i];
        }
      }
      if (child[0].low[0] == Bounds3::kInfinity) {
        for (int axis = 0; axis < 3; ++axis) {
          Expect(child[0].low[axis] == Bounds3::kInfinity, "empty box");
          Expect(child[0].high[axis] == -Bounds3::kInfinity, "empty box");
        }
        continue;
      }
      Expect(static_cast<int>(count) == i, "used children come first");
      ++count;
      for (int end = 0; end < 2; ++end) {
        Expect(box[end].Contains(child[end]), "a child lies in its parent");
      }
      const Facts below = Walk(node.child[i], child, RecordOf(reference));
      facts.depth = std::max(facts.depth, below.depth);
      facts.need = std::max(facts.need, below.need);
      facts.tree_need = std::max(facts.tree_need, below.tree_need);
    }
    Expect(count > 0, "a node has children");
    facts.depth += 1;
    facts.need += count - 1;
    facts.tree_need += count - 1;
    return facts;
  }

  void CheckTriangles(Reference reference, const Box (&box)[2]) {
    const auto& leaf =
        *reinterpret_cast<const TriangleLeaf*>(&group_.records.data()[RecordOf(reference)]);
    ++triangle_leaves_;
    const GroupItem& item = input_.at(leaf.item);
    const TriangleInput& mesh = std::get<TriangleInput>(item.content);
    const size_t vertices = mesh.positions.size() / mesh.steps;
    const bool is_plain = item.mask == kAnyRay && !item.filter && mesh.steps == 1;
    Expect(is_plain == (KindOf(reference) == RecordKind::kTriangles), "kind of triangles");
    Expect(leaf.steps == mesh.steps, "steps");
    Expect(leaf.lanes != 0 && (leaf.lanes & (leaf.lanes + 1)) == 0 && leaf.lanes < 256, "lanes");
    std::vector<float> content = {static_cast<float>(leaf.item)};
    uint32_t used_vertices = 0;
    for (int i = 0; i < 8; ++i) {
      if ((leaf.lanes >> i & 1) == 0) {
        for (int c = 0; c < 3; ++c) Expect(leaf.Corner(c, i) == 0, "corners of unused lanes");
        continue;
      }
      const uint32_t id = group_.triangle_ids.at(leaf.first + static_cast<uint32_t>(i));
      Expect(i == 0 || id > group_.triangle_ids.at(leaf.first + static_cast<uint32_t>(i) - 1),
             "ids are ordered");
      content.push_back(static_cast<float>(id));
      ++found_[{leaf.item, id}];
      constexpr float kInf = Bounds3::kInfinity;
      Box around = {{kInf, kInf, kInf}, {-kInf, -kInf, -kInf}};
      for (int c = 0; c < 3; ++c) {
        const uint32_t place = leaf.Corner(c, i);
        used_vertices |= 1u << place;
        for (uint32_t step = 0; step < mesh.steps; ++step) {
          const float* rows = &leaf.vertex[0][0] + 24 * step;
          const Vec3 p{rows[place], rows[8 + place], rows[16 + place]};
          const Vec3 expected =
              mesh.positions[step * vertices + mesh.triangles[id][static_cast<size_t>(c)]];
          Expect(p == expected, "position of a corner");
          const float t =
              mesh.steps == 1 ? 0 : static_cast<float>(step) / static_cast<float>(mesh.steps - 1);
          if (mesh.steps > 1) Expect(Between(box, t).Contains(p), "a moving corner in its box");
          for (int axis = 0; axis < 3; ++axis) {
            around.low[axis] = std::min(around.low[axis], p[axis]);
            around.high[axis] = std::max(around.high[axis], p[axis]);
          }
        }
      }
      if (mesh.steps == 1) {
        Expect(box[0].Meets(around), "a triangle meets its box");
        if (whole_triangles_) {
          float extent = 0;
          for (int axis = 0; axis < 3; ++axis) {
            extent = std::max(extent, around.high[axis] - around.low[axis]);
          }
          for (int axis = 0; axis < 3; ++axis) {
            const double pad = 4e-7 * static_cast<double>(extent);
            Expect(static_cast<double>(box[0].low[axis]) <=
                       static_cast<double>(around.low[axis]) - pad,
                   "padding below");
            Expect(static_cast<double>(box[0].high[axis]) >=
                       static_cast<double>(around.high[axis]) + pad,
                   "padding above");
          }
        }
      }
    }
    for (int v = 0; v < 8; ++v) {
      if ((used_vertices >> v & 1) != 0) continue;
      for (int axis = 0; axis < 3; ++axis) {
        Expect(leaf.vertex[axis][v] == leaf.vertex[axis][0], "unused vertices");
      }
    }
    AddLeaf(std::move(content), box);
  }

  void CheckPrimitives(Reference reference, const Box (&box)[2]) {
    const auto& leaf =
        *reinterpret_cast<const PrimitiveLeaf*>(&group_.records.data()[RecordOf(reference)]);
    std::vector<float> content;
    Expect(leaf.count > 0 && leaf.count <= PrimitiveLeaf::kMost, "primitives in a leaf");
    for (uint32_t i = 0; i < leaf.count; ++i) {
      const auto [item, primitive] = leaf.entry[i];
      ++found_[{item, primitive}];
      content.push_back(static_cast<float>(item));
      content.push_back(static_cast<float>(primitive));
      const PrimitiveSet& set = *std::get<PrimitiveInput>(input_.at(item).content).set;
      for (uint32_t step = 0; step < set.TimeSteps(); ++step) {
        const Bounds3 bounds = set.PrimitiveBounds(primitive, step);
        const float t = set.TimeSteps() == 1
                            ? 0
                            : static_cast<float>(step) / static_cast<float>(set.TimeSteps() - 1);
        const Box at = set.TimeSteps() == 1 ? box[0] : Between(box, t);
        Expect(at.Contains(bounds.min) && at.Contains(bounds.max), "a primitive in its box");
      }
    }
    AddLeaf(std::move(content), box);
  }

  void AddLeaf(std::vector<float> content, const Box (&box)[2]) {
    for (const Box& each : box) {
      content.insert(content.end(), each.low, each.low + 3);
      content.insert(content.end(), each.high, each.high + 3);
    }
    leaves_.insert(std::move(content));
  }

  static Box Between(const Box (&box)[2], float t) {
    Box result;
    for (int axis = 0; axis < 3; ++axis) {
      result.low[axis] = box[0].low[axis] * (1 - t) + box[1].low[axis] * t;
      result.high[axis] = box[0].high[axis] * (1 - t) + box[1].high[axis] * t;
    }
    return result;
  }

  const GroupInput& input_;
  const GroupData& group_;
  const bool whole_triangles_;
  std::string problems_;
  std::map<std::pair<uint32_t, uint32_t>, int> found_;
  std::multiset<std::vector<float>> leaves_;
  size_t triangle_leaves_ = 0, nodes_ = 0;
};

}  // namespace candela::kernel::testing_support
