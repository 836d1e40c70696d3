#include "lights/light_tree.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "lights/light_tree_builder.h"
#include "math/elementary.h"

namespace candela {
namespace {

/// Sine and cosine of an angle from 0 to half a turn.
struct Angle {
  float cos, sin;

  /// What is left of it without another, at least 0.
  Angle Without(Angle other) const {
    if (other.cos <= cos) return {1, 0};
    return {cos * other.cos + sin * other.sin, sin * other.cos - cos * other.sin};
  }
};

float SineOf(float cosine) {
  return std::sqrt(std::max(0.0f, 1 - cosine * cosine));
}

Angle AngleOf(float cosine) {
  const float limited = std::clamp(cosine, -1.0f, 1.0f);
  return {limited, SineOf(limited)};
}

}  // namespace

LightTree::LightTree(std::span<const LightReach> lights) {
  CHECK(!lights.empty() && lights.size() < (size_t{1} << 30));
  LightTreeBuilder builder(lights);
  trails_.resize(lights.size());
  nodes_.reserve(2 * lights.size() - 1);
  nodes_.push_back(NodeOf(builder.Root().cluster));

  struct Step {
    uint32_t node;
    LightTreeBuilder::Part part;
    uint64_t trail;
  };
  std::vector<Step> steps = {{0, builder.Root(), 0}};
  while (!steps.empty()) {
    const Step step = steps.back();
    steps.pop_back();
    if (step.part.Count() == 1) {
      const uint32_t light = builder.LightAt(step.part.begin);
      nodes_[step.node].next = light;
      nodes_[step.node].is_leaf = 1;
      trails_[light] = step.trail;
      continue;
    }
    const auto [first, second] = builder.Split(step.part);
    const auto next = static_cast<uint32_t>(nodes_.size());
    nodes_[step.node].next = next & 0x7FFFFFFF;
    nodes_.push_back(NodeOf(first.cluster));
    nodes_.push_back(NodeOf(second.cluster));
    steps.push_back({next + 1, second, step.trail | (uint64_t{1} << step.part.depth)});
    steps.push_back({next, first, step.trail});
  }
}

LightTree::Node LightTree::NodeOf(const LightCluster& cluster) {
  Node node{};
  node.center = cluster.box.Center();
  node.radius = Length(cluster.box.Extent()) / 2;
  node.power = static_cast<float>(cluster.power);
  // Nothing is known of where those shine that go around more than half of all directions.
  if (cluster.spread + cluster.cone < kPi) node.axis = ToFloat(cluster.axis);
  node.cos_spread = static_cast<float>(Cos(cluster.spread));
  node.sin_spread = static_cast<float>(Sin(cluster.spread));
  node.cos_cone = static_cast<float>(Cos(cluster.cone));
  node.is_flat = cluster.is_flat;
  node.is_two_sided = cluster.is_two_sided;
  return node;
}

float LightTree::Effect(const Node& node, const Receiver& to) {
  const Vec3 way = to.p - node.center;
  const float squared = LengthSquared(way);
  const float radius_squared = node.radius * node.radius;
  float toward = 1;
  if (squared > radius_squared && (node.axis != Vec3() || to.n != Vec3())) {
    const float distance = std::sqrt(squared);
    const float sine_of_ball = node.radius / distance;
    const Angle ball{SineOf(sine_of_ball), sine_of_ball};
    if (to.n != Vec3()) {
      // The least angle between the normal and the way to a light.
      toward = AngleOf(-Dot(way, to.n) / distance).Without(ball).cos;
      if (!(toward > 0)) return 0;
    }
    if (node.axis != Vec3()) {
      // That between the axis of a light and the way from it to the point.
      const float cosine = Dot(way, node.axis) / distance;
      const Angle least = AngleOf(node.is_two_sided ? std::abs(cosine) : cosine)
                              .Without({node.cos_spread, node.sin_spread})
                              .Without(ball);
      if (least.cos < node.cos_cone) return 0;
      if (node.is_flat) toward *= std::max(least.cos, 0.0f);
    }
  }
  // From within, or nearly, it does not grow any more.
  const float limited = std::max({squared, radius_squared, 1e-30f});
  constexpr auto kInverseSphere = static_cast<float>(1 / (4 * kPi));
  const float effect = node.power * toward * kInverseSphere / limited;
  return effect < 1e30f ? effect : 1e30f;
}

float LightTree::FirstShare(const Node& node, const Receiver& to) const {
  const float first = Effect(nodes_[node.next], to);
  const float sum = first + Effect(nodes_[node.next + 1], to);
  return sum > 0 ? first / sum : 0.5f;
}

LightTree::Pick LightTree::Choose(const Receiver& to, double u) const {
  constexpr double kLast = 0x1.fffffffffffffp-1;
  float probability = 1;
  const Node* node = &nodes_[0];
  while (!node->is_leaf) {
    const float share = FirstShare(*node, to);
    const bool is_first = u < double{share};
    const double part = is_first ? double{share} : 1 - double{share};
    u = std::min((is_first ? u : u - double{share}) / part, kLast);
    probability *= is_first ? share : 1 - share;
    node = &nodes_[node->next + (is_first ? 0 : 1)];
  }
  return {node->next, probability};
}

float LightTree::Probability(const Receiver& to, uint32_t light) const {
  float probability = 1;
  uint64_t trail = trails_[light];
  for (const Node* node = &nodes_[0]; !node->is_leaf; trail >>= 1) {
    const bool is_first = (trail & 1) == 0;
    const float share = FirstShare(*node, to);
    probability *= is_first ? share : 1 - share;
    node = &nodes_[node->next + (is_first ? 0 : 1)];
  }
  return probability;
}

}  // namespace candela
