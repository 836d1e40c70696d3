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

LightPicker::Pick LightPicker::Choose(Vec3 p, float u) const {
  DCHECK(HasLights());
  if (candidates_.size() == 1) return {candidates_[0].light, 1};
  if (!looks_at_each_) {
    const Candidate& chosen = candidates_[table_->Draw(double{u}).index];
    return {chosen.light, chosen.share};
  }
  std::array<float, kFew> effects;
  const float sum = Effects(p, effects);
  // The last one takes what rounding leaves.
  const size_t last = candidates_.size() - 1;
  for (size_t i = 0; i < last; ++i) {
    const float probability = ProbabilityOf(candidates_[i], effects[i], sum);
    if (u < probability) return {candidates_[i].light, probability};
    u -= probability;
  }
  return {candidates_[last].light, ProbabilityOf(candidates_[last], effects[last], sum)};
}

float LightPicker::Probability(Vec3 p, uint32_t light) const {
  const uint32_t index = candidate_of_light_[light];
  if (index == kNever) return 0;
  const Candidate& candidate = candidates_[index];
  if (candidates_.size() == 1) return 1;
  if (!looks_at_each_) return candidate.share;
  std::array<float, kFew> effects;
  const float sum = Effects(p, effects);
  return ProbabilityOf(candidate, effects[index], sum);
}

}  // namespace candela
