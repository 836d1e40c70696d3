#include "textures/registry.h"

#include "scene_spec/registry.h"
#include "textures/checker_texture.h"
#include "textures/constant_texture.h"
#include "textures/image_texture.h"
#include "textures/mix_texture.h"
#include "textures/noise_texture.h"
#include "textures/ramp_texture.h"
#include "textures/triplanar_texture.h"
#include "textures/uv_texture.h"
#include "textures/veined_texture.h"
#include "textures/voronoi_texture.h"

namespace candela {
namespace {

constexpr TextureEntry kTextures[] = {
    // name     create            example
    {"constant", &ConstantTexture::Create, "type constant color 0.8 0.4 0.2"},
    {"checker", &CheckerTexture::Create, "type checker even 0.9 0.9 0.9 odd 0.1 0.1 0.1 scale 8 8"},
    {"image", &ImageTexture::Create, "type image file tex/rotunda/front.png wrap mirror"},
    {"noise", &NoiseTexture::Create, "type noise low 0.1 0.2 0.4 high 1 1 1 octaves 5 scale 3 3 3"},
    {"turbulence", &NoiseTexture::CreateTurbulence, "type turbulence high 0.9 0.5 0.1 gain 0.6"},
    {"marble", &VeinedTexture::CreateMarble, "type marble low 0.2 0.2 0.3 high 0.9 0.9 0.85"},
    {"wood", &VeinedTexture::CreateWood,
     "type wood low 0.6 0.4 0.2 high 0.3 0.15 0.05 scale 9 9 9"},
    {"voronoi", &VoronoiTexture::Create, "type voronoi feature edges scale 4 4 4"},
    {"ramp", &RampTexture::Create, "type ramp stops 0 0.1 0.1 0.4 1 0.9 0.8 0.6 along y"},
    {"uv", &UvTexture::Create, "type uv scale 2 2"},
    {"mix", &MixTexture::Create, "type mix first 0.9 0.1 0.1 second 0.1 0.1 0.9 amount 0.3"},
    {"triplanar", &TriplanarTexture::Create, "type triplanar input texture squares sharpness 8"},
};

}  // namespace

std::span<const TextureEntry> TextureEntries() {
  return kTextures;
}

std::shared_ptr<const Texture> CreateTexture(const TypedSpec& spec, const TextureContext& context) {
  const TextureEntry* entry =
      FindEntry<TextureEntry>(kTextures, spec, "texture", context.diagnostics);
  if (!entry) return nullptr;
  ParamReader params(spec.params, entry->name, spec.where, context.diagnostics, context.resolved);
  // The loader has taken these; a parameter that was meant as one of them is told so.
  for (const std::string_view name : {"type", "name"}) params.Has(name);
  auto texture = entry->create(&params, context);
  params.Finish();
  return texture;
}

}  // namespace candela
