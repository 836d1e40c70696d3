#include "textures/texture_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace candela {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();
constexpr Rgb kBlack{0, 0, 0}, kWhite{1, 1, 1};

/// The texture that the parameter names; null when it names none, or none that there is.
std::shared_ptr<const Texture> TextureOf(ParamReader* params, std::string_view name,
                                         const TextureContext& context) {
  const ParamWord* word = params->TextureName(name);
  return word ? context.find_texture(word->text, word->where) : nullptr;
}

}  // namespace

std::shared_ptr<const Texture> TextureParam(ParamReader* params, std::string_view name,
                                            const TextureContext& context) {
  if (!params->Has(name)) return nullptr;
  if (params->IsTexture(name)) return TextureOf(params, name, context);
  params->Error(params->Where(name), fmt::format("'{}' expects a texture", name));
  return nullptr;
}

ColorInput::ColorInput(std::shared_ptr<const Texture> texture, Rgb least, Rgb most)
    : texture_(std::move(texture)), least_(least), most_(most) {}

ColorInput ColorInput::Color(ParamReader* params, std::string_view name, Rgb default_value,
                             const TextureContext& context) {
  if (!params->IsTexture(name)) return params->Color(name, default_value);
  const Rgb most{kLargest, kLargest, kLargest};
  auto texture = TextureOf(params, name, context);
  return texture ? ColorInput(std::move(texture), -most, most) : default_value;
}

ColorInput ColorInput::Albedo(ParamReader* params, std::string_view name, Rgb default_value,
                              const TextureContext& context) {
  if (!params->IsTexture(name)) return params->Albedo(name, default_value);
  auto texture = TextureOf(params, name, context);
  return texture ? ColorInput(std::move(texture), kBlack, kWhite) : default_value;
}

Rgb ColorInput::Textured(const SurfacePoint& point) const {
  return Max(least_, Min(most_, texture_->Lookup(point)));
}

NumberInput NumberInput::Fraction(ParamReader* params, std::string_view name, float default_value,
                                  const TextureContext& context) {
  if (!params->IsTexture(name)) return params->Fraction(name, default_value);
  auto texture = TextureOf(params, name, context);
  return texture ? NumberInput(std::move(texture)) : default_value;
}

float NumberInput::Textured(const SurfacePoint& point) const {
  const Rgb c = texture_->Lookup(point);
  return std::clamp((c.x + c.y + c.z) / 3, 0.0f, 1.0f);
}

}  // namespace candela
