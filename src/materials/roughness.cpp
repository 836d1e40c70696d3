#include "materials/roughness.h"

namespace candela {

Roughness Roughness::Create(ParamReader* params, const MaterialContext& context) {
  Roughness roughness;
  roughness.input_ = NumberInput::Fraction(params, "roughness", 0, context);
  roughness.alpha_ = roughness.input_.value() * roughness.input_.value();
  return roughness;
}

Roughness Roughness::OfAlpha(float alpha) {
  Roughness roughness;
  roughness.alpha_ = alpha;
  return roughness;
}

float Roughness::AlphaAt(const SurfacePoint& point) const {
  if (!input_.IsTextured()) return alpha_;
  const float root = input_.At(point);
  return root * root;
}

EnergyTable Roughness::MakeTable(const EnergyTable::Facet& facet) const {
  return input_.IsTextured() ? EnergyTable::OfAllRoughness(facet)
                             : EnergyTable::OfRoughness(alpha_, facet);
}

float Roughness::TableRow(float alpha) const {
  return input_.IsTextured() ? EnergyTable::RowOfRoughness(alpha) : 0;
}

}  // namespace candela
