#include "lights/light_picker.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.h"
#include "math/elementary.h"

namespace candela {
namespace {

/// The part of the choice that goes by distance, where lights are few. The rest is even.
constexpr float kByDistance = 0.8f;
/// The same where they are many. The rest is by power.
constexpr float kByTree = 0.9f;

}  // namespace

LightPicker::LightPicker(std::span<const Light* const> lights, float size, LightChoice choice) {
  candidate_of_light_.assign(lights.size(), kNever);
  std::vector<double> powers;
  for (uint32_t i = 0; i < lights.size(); ++i) {
    const LightReach reach = lights[i]->Reach();
    if (!(reach.power > 0)) continue;
    candidate_of_light_[i] = static_cast<uint32_t>(candidates_.size());
    candidates_.push_back({i, reach, 0});
    // The flux that a far light sends into a ball of the size of the scene.
    const double area = reach.is_far ? 4 * kPi * double{size} * size : 1;
    powers.push_back(choice == LightChoice::kUniform ? 1 : double{reach.power} * area);
  }
  if (candidates_.empty()) return;
  looks_at_each_ = choice == LightChoice::kByEffect && candidates_.size() <= kFew;
  if (looks_at_each_) std::fill(powers.begin(), powers.end(), 1.0);
  double sum = 0;
  for (const double power : powers) sum += power;
  for (size_t i = 0; i < powers.size(); ++i) {
    candidates_[i].share = static_cast<float>(powers[i] / sum);
  }
  if (!looks_at_each_) table_.emplace(powers);
  if (!looks_at_each_ && choice == LightChoice::kByEffect) PlantTree();
}

void LightPicker::PlantTree() {
  std::vector<LightReach> near;
  std::vector<double> far_powers;
  for (uint32_t i = 0; i < candidates_.size(); ++i) {
    const LightReach& reach = candidates_[i].reach;
    std::vector<uint32_t>& list = reach.is_far ? far_ : near_;
    parts_.push_back({reach.is_far, static_cast<uint32_t>(list.size())});
    list.push_back(i);
    if (reach.is_far) {
      far_powers.push_back(double{reach.power});
      far_effect_ += double{reach.power};
    } else {
      near.push_back(reach);
    }
  }
  if (!near.empty()) tree_.emplace(near);
  if (!far_powers.empty()) far_table_.emplace(far_powers);
}

float LightPicker::Effect(const LightReach& reach, Vec3 p) {
  if (reach.is_far) return reach.power;
  const Vec3 way = p - reach.center;
  const float squared = LengthSquared(way);
  float toward = 1;
  if (reach.axis != Vec3()) {
    const float distance = std::sqrt(squared);
    const float along = Dot(way, reach.axis);
    // Some of the ball may be nearer to the axis than its centre.
    if (along + reach.radius < reach.least_cosine * distance) return 0;
    if (reach.is_flat) toward = (std::abs(along) + reach.radius) / (distance + reach.radius);
  }
  // From within, or nearly, it does not grow any more.
  const float limited = std::max(squared, reach.radius * reach.radius);
  constexpr auto kInverseSphere = static_cast<float>(1 / (4 * kPi));
  const float effect = reach.power * toward * kInverseSphere / std::max(limited, 1e-30f);
  return std::min(effect, 1e30f);
}

float LightPicker::Effects(Vec3 p, std::span<float> effects) const {
  float sum = 0;
  for (size_t i = 0; i < candidates_.size(); ++i) {
    effects[i] = Effect(candidates_[i].reach, p);
    sum += effects[i];
  }
  return sum;
}

float LightPicker::ProbabilityOf(const Candidate& candidate, float effect, float sum) const {
  if (candidates_.size() == 1) return 1;
  if (!(sum > 0)) return candidate.share;
  return kByDistance * (effect / sum) + (1 - kByDistance) * candidate.share;
}

float LightPicker::ShareOfTree(const Receiver& to) const {
  if (!tree_) return 0;
  if (!far_table_) return 1;
  const double near = double{tree_->Effect(to)};
  return static_cast<float>(near / (near + far_effect_));
}

float LightPicker::ChoiceOf(Part part, const Receiver& to) const {
  const float share = ShareOfTree(to);
  if (!part.is_far) return share * tree_->Probability(to, part.place);
  const double power = double{candidates_[far_[part.place]].reach.power};
  return (1 - share) * static_cast<float>(power / far_effect_);
}

float LightPicker::ProbabilityOfMany(const Candidate& candidate, float choice) {
  return kByTree * choice + (1 - kByTree) * candidate.share;
}

LightPicker::Pick LightPicker::ChooseOfMany(const Receiver& to, double u) const {
  constexpr double kLast = 0x1.fffffffffffffp-1;
  uint32_t index;
  if (u >= double{kByTree}) {
    const double rest = std::min((u - double{kByTree}) / (1 - double{kByTree}), kLast);
    index = table_->Draw(rest).index;
  } else {
    u = std::min(u / double{kByTree}, kLast);
    const float share = ShareOfTree(to);
    if (u < double{share}) {
      const LightTree::Pick pick = tree_->Choose(to, std::min(u / double{share}, kLast));
      const Candidate& chosen = candidates_[near_[pick.light]];
      return {chosen.light, ProbabilityOfMany(chosen, share * pick.probability)};
    }
    const double rest = std::min((u - double{share}) / (1 - double{share}), kLast);
    index = far_[far_table_->Draw(rest).index];
  }
  const Candidate& chosen = candidates_[index];
  return {chosen.light, ProbabilityOfMany(chosen, ChoiceOf(parts_[index], to))};
}

LightPicker::Pick LightPicker::Choose(const Receiver& to, float u) const {
  DCHECK(HasLights());
  if (candidates_.size() == 1) return {candidates_[0].light, 1};
  if (!parts_.empty()) return ChooseOfMany(to, double{u});
  if (!looks_at_each_) {
    const Candidate& chosen = candidates_[table_->Draw(double{u}).index];
    return {chosen.light, chosen.share};
  }
  std::array<float, kFew> effects;
  const float sum = Effects(to.p, effects);
  // The last one takes what rounding leaves.
  const size_t last = candidates_.size() - 1;
  for (size_t i = 0; i < last; ++i) {
    const float probability = ProbabilityOf(candidates_[i], effects[i], sum);
    if (u < probability) return {candidates_[i].light, probability};
    u -= probability;
  }
  return {candidates_[last].light, ProbabilityOf(candidates_[last], effects[last], sum)};
}

float LightPicker::Probability(const Receiver& to, uint32_t light) const {
  const uint32_t index = candidate_of_light_[light];
  if (index == kNever) return 0;
  const Candidate& candidate = candidates_[index];
  if (candidates_.size() == 1) return 1;
  if (!parts_.empty()) return ProbabilityOfMany(candidate, ChoiceOf(parts_[index], to));
  if (!looks_at_each_) return candidate.share;
  std::array<float, kFew> effects;
  const float sum = Effects(to.p, effects);
  return ProbabilityOf(candidate, effects[index], sum);
}

uint64_t LightPicker::MemoryBytes() const {
  uint64_t bytes =
      candidates_.capacity() * sizeof(Candidate) +
      (candidate_of_light_.capacity() + near_.capacity() + far_.capacity()) * sizeof(uint32_t) +
      parts_.capacity() * sizeof(Part);
  if (table_) bytes += table_->MemoryBytes();
  if (far_table_) bytes += far_table_->MemoryBytes();
  if (tree_) bytes += tree_->MemoryBytes();
  return bytes;
}

}  // namespace candela
