#include "scene/node_places.h"

#include <fmt/format.h>

#include <cstdint>
#include <numeric>
#include <utility>

#include "math/moving_transform.h"

namespace candela {
namespace {

/// Small texts must not ask for large memory: so many matrices take 268 MB.
constexpr size_t kMostMatrices = size_t{1} << 21;

/// The matrix at the moment `index` of `parts` even parts of the time, of `steps`, whose moments
/// are among them.
Mat4 MatrixAtMoment(const std::vector<Mat4>& steps, size_t index, size_t parts) {
  const size_t moments_per_step = parts / (steps.size() - 1);
  const size_t step = index / moments_per_step, rest = index % moments_per_step;
  if (rest == 0) return steps[step];
  return Blend(steps[step], steps[step + 1],
               static_cast<double>(rest) / static_cast<double>(moments_per_step));
}

NodePlace Product(const NodePlace& parent, const NodePlace& node, const SourceLocation& where,
                  Diagnostics* diagnostics) {
  NodePlace product{parent.begin * node.begin, {}};
  if (!parent.IsMoving() && !node.IsMoving()) return product;
  if (!parent.IsMoving()) {
    for (const Mat4& step : node.motion) product.motion.push_back(parent.begin * step);
    return product;
  }
  if (!node.IsMoving()) {
    for (const Mat4& step : parent.motion) product.motion.push_back(step * node.begin);
    return product;
  }
  const size_t parts = std::lcm(parent.motion.size() - 1, node.motion.size() - 1);
  if (parts >= NodeSpec::kMostSteps) {
    diagnostics->Error(where, [&] {
      return fmt::format(
          "the node moves in {} steps within one that moves in {}: together that makes {}, and at "
          "most {} are possible; fewer it takes when one of {} and {}, the parts of their ways, "
          "divides the other",
          node.motion.size(), parent.motion.size(), parts + 1, NodeSpec::kMostSteps,
          node.motion.size() - 1, parent.motion.size() - 1);
    });
    return product;
  }
  for (size_t i = 0; i <= parts; ++i) {
    product.motion.push_back(MatrixAtMoment(parent.motion, i, parts) *
                             MatrixAtMoment(node.motion, i, parts));
  }
  return product;
}

}  // namespace

std::vector<NodePlace> PlacesOfNodes(const SceneSpec& spec, Diagnostics* diagnostics) {
  std::vector<NodePlace> places;
  places.reserve(spec.nodes.size());
  size_t matrices = 0;
  for (const NodeSpec& node : spec.nodes) {
    NodePlace own{node.motion.empty() ? node.parent_from_node : node.motion.front(), node.motion};
    places.push_back(node.parent == NodeSpec::kNoParent
                         ? std::move(own)
                         : Product(places[node.parent], own, node.transform_where, diagnostics));
    matrices += places.back().motion.size();
    if (matrices <= kMostMatrices) continue;
    // It may lie where it does by the keyframes around it.
    const NodeSpec* placed = &node;
    while (placed->transform_where.line == 0) placed = &spec.nodes[placed->parent];
    diagnostics->Error(placed->transform_where, [&] {
      return fmt::format(
          "the nodes up to here move in more than {} steps together, for which there is no room; "
          "keyframes with smaller turns and fewer nodes within moving ones take fewer",
          kMostMatrices);
    });
    places.resize(spec.nodes.size());
    break;
  }
  return places;
}

}  // namespace candela
