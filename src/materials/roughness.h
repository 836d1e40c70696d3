#pragma once

#include <memory>
#include <string_view>

#include "materials/energy_table.h"
#include "materials/material_context.h"
#include "textures/texture_input.h"

namespace candela {

/// How rough a surface is, by number or by texture: a parameter, mostly `roughness`, whose square
/// is the alpha of `Ggx`.
class Roughness {
 public:
  static Roughness Create(ParamReader* params, const MaterialContext& context,
                          std::string_view name = "roughness", float default_value = 0);
  static Roughness OfAlpha(float alpha);
  static Roughness OfTexture(std::shared_ptr<const Texture> texture);

  float AlphaAt(const SurfacePoint& point) const;
  /// Whether the surface is polished at all points.
  bool IsNowhere() const { return !input_.IsTextured() && alpha_ < kSmoothestAlpha; }

  /// A table for all alphas that there may be, and the row of one of them.
  EnergyTable MakeTable(const EnergyTable::Facet& facet,
                        EnergyTable::Detail detail = EnergyTable::Detail::kSmooth) const;
  float TableRow(float alpha) const;

  bool IsTextured() const { return input_.IsTextured(); }
  bool NeedsTextureCoordinates() const { return input_.NeedsTextureCoordinates(); }

 private:
  NumberInput input_;
  float alpha_ = 0;  ///< Without a texture.
};

}  // namespace candela
