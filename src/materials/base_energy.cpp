#include "materials/base_energy.h"

#include <algorithm>
#include <cmath>

#include "materials/lobe.h"

namespace candela {
namespace {

// The nodes of the grid are spaced evenly in the root of alpha, and in the aspect of the facets.
constexpr size_t kRoughnesses = 12, kBrushings = 6;
constexpr int kAzimuthRows = 7;

float AspectOf(float anisotropy) {
  return std::sqrt(1 - 0.9f * anisotropy);
}
float AnisotropyOf(float aspect) {
  return (1 - aspect * aspect) / 0.9f;
}
float LeastAspect() {
  return AspectOf(1);
}

bool IsBrushed(const NumberInput& anisotropy) {
  return anisotropy.IsTextured() || anisotropy.value() > 0;
}

/// Between two neighbours of `count` nodes.
struct Step {
  Step(float position, size_t count)
      : index(std::min(static_cast<size_t>(std::max(position, 0.0f)), count > 1 ? count - 2 : 0)),
        part(count > 1 ? std::clamp(position - static_cast<float>(index), 0.0f, 1.0f) : 0) {}
  size_t index;
  float part;
};

}  // namespace

Ggx Brushed(float alpha, float anisotropy) {
  const float aspect = AspectOf(anisotropy);
  return {std::min(std::max(alpha / aspect, kSmoothestAlpha), 1.0f),
          std::max(alpha * aspect, kSmoothestAlpha)};
}

BaseEnergy::BaseEnergy(const Roughness& roughness, const NumberInput& anisotropy,
                       const EnergyTable::Facet& facet)
    : is_brushed_(IsBrushed(anisotropy)) {
  if (!is_brushed_) {
    tables_.push_back(roughness.MakeTable(facet));
    return;
  }
  if (!roughness.IsTextured() && !anisotropy.IsTextured()) {
    const Ggx surface = Brushed(roughness.AlphaAt({}), anisotropy.value());
    tables_.push_back(EnergyTable::OfAnisotropic(surface, facet));
    return;
  }
  if (roughness.IsTextured()) roughnesses_ = kRoughnesses;
  if (anisotropy.IsTextured()) brushings_ = kBrushings;
  rows_per_azimuth_row_ = EnergyTable::AzimuthScale(kAzimuthRows);
  for (size_t y = 0; y < roughnesses_; ++y) {
    const float root = static_cast<float>(y) / (kRoughnesses - 1);
    const float alpha = roughness.IsTextured() ? root * root : roughness.AlphaAt({});
    for (size_t x = 0; x < brushings_; ++x) {
      const float part = static_cast<float>(x) / (kBrushings - 1);
      const float aspect = 1 - part * (1 - LeastAspect());
      const float brushing = anisotropy.IsTextured() ? AnisotropyOf(aspect) : anisotropy.value();
      tables_.push_back(EnergyTable::OfAnisotropic(Brushed(alpha, std::min(brushing, 1.0f)), facet,
                                                   EnergyTable::Detail::kCoarse, kAzimuthRows));
    }
  }
}

BaseEnergy::Place BaseEnergy::PlaceOf(float alpha, float anisotropy) const {
  alpha = std::max(alpha, kSmoothestAlpha);
  if (!is_brushed_) {
    return {tables_[0].RowCount() > 1 ? EnergyTable::RowOfRoughness(alpha) : 0, 0};
  }
  Place place{0, 0};
  if (roughnesses_ > 1) place.row = std::sqrt(alpha) * (kRoughnesses - 1);
  if (brushings_ > 1) {
    place.brushing = (1 - AspectOf(anisotropy)) / (1 - LeastAspect()) * (kBrushings - 1);
  }
  return place;
}

BaseEnergy::Corners BaseEnergy::CornersOf(const Place& place) const {
  const Step y(place.row, roughnesses_), x(place.brushing, brushings_);
  const size_t first = y.index * brushings_ + x.index;
  return {
      {first, first + 1, first + brushings_, first + brushings_ + 1},
      {(1 - y.part) * (1 - x.part), (1 - y.part) * x.part, y.part * (1 - x.part), y.part * x.part}};
}

float BaseEnergy::Mean(const Place& place) const {
  const float row = RowOfMean(place);
  return Blend(place, [&](size_t i) { return tables_[i].Mean(row); });
}

Vec3 BaseEnergy::SampleMissing(const Place& place, Vec2 u) const {
  if (tables_.size() == 1) return tables_[0].SampleMissing(place.row, u);
  const Corners corners = CornersOf(place);
  float left = 1;
  int chosen = 0;
  // The last one that can be chosen takes what rounding has left.
  for (int i = 0; i < 4; ++i) {
    if (!(corners.weight[i] > 0)) continue;
    chosen = i;
    if (SplitChoice(std::min(corners.weight[i] / left, 1.0f), &u.x)) break;
    left -= corners.weight[i];
  }
  return tables_[corners.index[chosen]].SampleMissing(0, u);
}

float BaseEnergy::MissingPdf(const Place& place, float cosine) const {
  const float row = RowOfMean(place);
  return Blend(place, [&](size_t i) { return tables_[i].MissingPdf(cosine, row); });
}

std::vector<float> BaseEnergy::MeansOfProduct(const EnergyTable& above) const {
  std::vector<float> means;
  for (const EnergyTable& table : tables_) {
    const int rows = is_brushed_ ? table.RowCount() : 1;
    for (int first = 0; first < table.RowCount(); first += rows) {
      for (int row_above = 0; row_above < above.RowCount(); ++row_above) {
        means.push_back(EnergyTable::MeanOfProduct(table, first, rows, above, row_above));
      }
    }
  }
  return means;
}

float BaseEnergy::MeanOfProduct(std::span<const float> means, const Place& place,
                                float row_above) const {
  const size_t lists = is_brushed_ ? tables_.size() : static_cast<size_t>(tables_[0].RowCount());
  const size_t columns = means.size() / lists;
  const Step x(row_above, columns);
  const auto at = [&](size_t list) {
    const float* here = &means[list * columns + x.index];
    return x.part == 0 ? here[0] : here[0] * (1 - x.part) + here[1] * x.part;
  };
  if (is_brushed_) return Blend(place, at);
  const Step y(place.row, lists);
  return y.part == 0 ? at(y.index) : at(y.index) * (1 - y.part) + at(y.index + 1) * y.part;
}

}  // namespace candela
