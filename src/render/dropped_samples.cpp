#include "render/dropped_samples.h"

#include <algorithm>
#include <tuple>

namespace candela {

void DroppedSamples::Add(const Sample& sample) {
  ++count_;
  Insert(sample);
}

DroppedSamples& DroppedSamples::operator+=(const DroppedSamples& other) {
  count_ += other.count_;
  for (const Sample& sample : other.first_) Insert(sample);
  return *this;
}

void DroppedSamples::Insert(const Sample& sample) {
  const auto is_before = [](const Sample& a, const Sample& b) {
    return std::tie(a.y, a.x, a.index) < std::tie(b.y, b.x, b.index);
  };
  if (first_.size() == kMostNamed && !is_before(sample, first_.back())) return;
  first_.insert(std::upper_bound(first_.begin(), first_.end(), sample, is_before), sample);
  if (first_.size() > kMostNamed) first_.pop_back();
}

}  // namespace candela
