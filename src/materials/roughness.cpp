#include "materials/roughness.h"

#include <algorithm>
#include <utility>

namespace candela {

Roughness Roughness::Create(ParamReader* params, const MaterialContext& context,
                            std::string_view name, float default_value) {
  Roughness roughness;
  roughness.input_ = NumberInput::Fraction(params, name, default_value, context);
  roughness.alpha_ = roughness.input_.value() * roughness.input_.value();
  return roughness;
}

Roughness Roughness::OfAlpha(float alpha) {
  Roughness roughness;
  roughness.alpha_ = alpha;
  return roughness;
}

Roughness Roughness::OfTexture(std::shared_ptr<const Texture> texture) {
  Roughness roughness;
  roughness.input_ = NumberInput(std::move(texture));
  return roughness;
}

float Roughness::AlphaAt(const SurfacePoint& point) const {
  if (!input_.IsTextured()) return alpha_;
  const float root = input_.At(point);
  return root * root;
}

EnergyTable Roughness::MakeTable(const EnergyTable::Facet& facet,
                                 EnergyTable::Detail detail) const {
  return input_.IsTextured()
             ? EnergyTable::OfAllRoughness(facet, detail)
             : EnergyTable::OfRoughness(std::max(alpha_, kSmoothestAlpha), facet, detail);
}

float Roughness::TableRow(float alpha) const {
  return input_.IsTextured() ? EnergyTable::RowOfRoughness(alpha) : 0;
}

}  // namespace candela
