#include "materials/principled.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "materials/fresnel.h"
#include "math/elementary.h"

namespace candela {
namespace {

constexpr auto kInvPi = static_cast<float>(1 / kPi);

/// What is left of a colour when its brightness is taken out: the largest component becomes 1.
Rgb HueOf(Rgb color) {
  const float largest = std::max(color.x, std::max(color.y, color.z));
  return largest > 0 ? color * (1 / largest) : Rgb{1, 1, 1};
}

Rgb Tinted(Rgb color, float tint) {
  return Rgb{1, 1, 1} * (1 - tint) + HueOf(color) * tint;
}

Rgb Over(Rgb a, Rgb b) {
  return {a.x / b.x, a.y / b.y, a.z / b.z};
}

/// What light takes on that met several facets of a metal, by Schlick's mean reflectance, over what
/// is missing on average and pi.
Rgb MultipleColour(Rgb head_on, float mean_share) {
  const Rgb f = head_on * (20.0f / 21) + Rgb{1, 1, 1} * (1.0f / 21);
  const Rgb kept = f * f * mean_share, lost = Rgb{1, 1, 1} - f * (1 - mean_share);
  return Over(kept, lost) * (kInvPi / std::max(1 - mean_share, 1e-7f));
}

}  // namespace

std::unique_ptr<Material> PrincipledMaterial::Create(ParamReader* params,
                                                     const MaterialContext& context) {
  const auto fraction = [&](std::string_view name, float default_value) {
    return NumberInput::Fraction(params, name, default_value, context);
  };
  Inputs inputs;
  inputs.base_color = ColorInput::Albedo(params, "base_color", {0.8f, 0.8f, 0.8f}, context);
  inputs.metallic = fraction("metallic", 0);
  inputs.roughness = Roughness::Create(params, context, "roughness", 0.5f);
  inputs.anisotropy = fraction("anisotropy", 0);
  inputs.rotation_degrees = params->Number("rotation", 0);
  inputs.specular = fraction("specular", 1);
  inputs.specular_tint = fraction("specular_tint", 0);
  inputs.ior = ReadRefractiveIndex(params, "ior", 1.5f);
  inputs.clearcoat = fraction("clearcoat", 0);
  inputs.clearcoat_roughness = Roughness::Create(params, context, "clearcoat_roughness", 0);
  inputs.sheen = fraction("sheen", 0);
  inputs.sheen_tint = fraction("sheen_tint", 0);
  inputs.sheen_roughness = fraction("sheen_roughness", 0.3f);
  inputs.transmission = fraction("transmission", 0);
  if (!(inputs.ior > 1)) {
    params->Error(params->Where("ior"), "a 'principled' surface has an 'ior' above 1");
    inputs.ior = 1.5f;
  }
  return std::make_unique<PrincipledMaterial>(std::move(inputs), context.media,
                                              context.energies.get());
}

PrincipledMaterial::PrincipledMaterial(Inputs inputs, std::span<const Medium> media,
                                       EnergyStore* energies)
    : inputs_(std::move(inputs)),
      layers_(inputs_.ior, inputs_.roughness, inputs_.anisotropy, inputs_.rotation_degrees,
              energies) {
  if (MayBeAbove0(inputs_.clearcoat)) layers_.AddCoat(inputs_.clearcoat_roughness);
  if (MayBeAbove0(inputs_.sheen)) layers_.AddSheen();
  if (MayBeAbove0(inputs_.transmission)) {
    glass_.emplace(Medium{inputs_.ior, {}}, inputs_.roughness, media, std::nullopt, energies);
  }
}

bool PrincipledMaterial::NeedsTextureCoordinates() const {
  const auto& i = inputs_;
  return IsBrushed() || i.base_color.NeedsTextureCoordinates() ||
         i.metallic.NeedsTextureCoordinates() || i.roughness.NeedsTextureCoordinates() ||
         i.specular.NeedsTextureCoordinates() || i.specular_tint.NeedsTextureCoordinates() ||
         i.clearcoat.NeedsTextureCoordinates() || i.clearcoat_roughness.NeedsTextureCoordinates() ||
         i.sheen.NeedsTextureCoordinates() || i.sheen_tint.NeedsTextureCoordinates() ||
         i.sheen_roughness.NeedsTextureCoordinates() || i.transmission.NeedsTextureCoordinates();
}

PhongTerms PrincipledMaterial::Phong(const SurfacePoint& point) const {
  const Rgb color = inputs_.base_color.At(point);
  const float metallic = inputs_.metallic.At(point);
  float beyond;
  const float glossy = DielectricReflectance(1, inputs_.ior, &beyond) * inputs_.specular.At(point);
  const Rgb specular =
      Tinted(color, inputs_.specular_tint.At(point)) * (glossy * (1 - metallic)) + color * metallic;
  const Rgb ground = color * ((1 - metallic) * (1 - inputs_.transmission.At(point)));
  return {ground, ground, specular, ShininessOf(inputs_.roughness.AlphaAt(point))};
}

Lobe PrincipledMaterial::OpaqueLobe(const SurfacePoint& point, Rgb base_color, float metallic,
                                    bool is_outside) const {
  Lobe lobe{LobeKind::kPrincipled, 1, Spectrum(base_color)};
  PrincipledParams& params = lobe.principled;
  params.layers = &layers_;
  params.sin_rotation = is_outside ? layers_.sin_rotation : -layers_.sin_rotation;
  const float alpha = inputs_.roughness.AlphaAt(point), anisotropy = inputs_.anisotropy.At(point);
  params.surface = Brushed(alpha, anisotropy);
  const BaseEnergy::Place place = layers_.metal->PlaceOf(alpha, anisotropy);
  params.row = place.row;
  params.brushing = place.brushing;
  params.metallic = metallic;
  params.specular =
      Tinted(base_color, inputs_.specular_tint.At(point)) * inputs_.specular.At(point);
  params.sheen = Tinted(base_color, inputs_.sheen_tint.At(point)) * inputs_.sheen.At(point);
  params.sheen_roughness = layers_.sheen ? inputs_.sheen_roughness.At(point) : 0;
  params.coat = inputs_.clearcoat.At(point);
  params.coat_alpha = params.coat_row = 0;
  // Of light from everywhere what the coat reflects, and what more the dielectric below it does,
  // but for its colour.
  float by_coat = 0, by_dielectric = layers_.dielectric->Mean(place);
  if (params.coat > 0) {
    params.coat_alpha = std::max(inputs_.clearcoat_roughness.AlphaAt(point), kSmoothestAlpha);
    params.coat_row = inputs_.clearcoat_roughness.TableRow(params.coat_alpha);
    by_coat = params.coat * layers_.coat->Mean(params.coat_row);
    by_dielectric -= params.coat * layers_.MeanProduct(place, params.coat_row);
  }
  const Rgb let_through = Rgb{1, 1, 1} * (1 - by_coat) - params.specular * by_dielectric;
  params.ground = Over(base_color * ((1 - metallic) * kInvPi), let_through);
  params.multiple = MultipleColour(base_color, layers_.metal->Mean(place)) * metallic;
  return lobe;
}

// Of the surface the part `metallic` is metal, and of the rest the part `transmission` is glass.
void PrincipledMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  if (IsBrushed()) bsdf->frame = Frame::FromNormalAndTangent(bsdf->frame.z, point.dpdu);
  const Rgb color = inputs_.base_color.At(point);
  const float metallic = inputs_.metallic.At(point);
  const float glass = glass_ ? (1 - metallic) * inputs_.transmission.At(point) : 0;
  if (glass < 1) {
    const int first = bsdf->count;
    // The frame is mirrored on the inside, and what is turned in it with it.
    const bool is_outside = Dot(point.n_shading, bsdf->frame.z) > 0;
    bsdf->Add(OpaqueLobe(point, color, std::min(metallic / (1 - glass), 1.0f), is_outside));
    if (glass > 0) bsdf->Mix(first, 1 - glass);
  }
  if (glass > 0) {
    const int first = bsdf->count;
    glass_->Evaluate(point, bsdf);
    // Light gets in and out again: by both together it takes on the colour.
    bsdf->lobes[first].weight =
        Spectrum(Rgb{std::sqrt(color.x), std::sqrt(color.y), std::sqrt(color.z)});
    if (glass < 1) bsdf->Mix(first, glass);
  }
}

}  // namespace candela
