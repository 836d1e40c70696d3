#include "textures/registry.h"

#include "scene_spec/registry.h"
#include "textures/checker_texture.h"
#include "textures/constant_texture.h"
#include "textures/image_texture.h"

namespace candela {
namespace {

constexpr TextureEntry kTextures[] = {
    // name     create            example
    {"constant", &ConstantTexture::Create, "type constant color 0.8 0.4 0.2"},
    {"checker", &CheckerTexture::Create, "type checker even 0.9 0.9 0.9 odd 0.1 0.1 0.1 scale 8 8"},
    {"image", &ImageTexture::Create, "type image file tex/rotunda/front.png wrap mirror"},
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
