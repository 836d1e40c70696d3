#pragma once

#include <memory>
#include <string_view>

#include "scene_spec/param_reader.h"
#include "textures/texture.h"
#include "textures/texture_context.h"

namespace candela {

/// The texture that a parameter names, which takes nothing else; null when it is missing, or wrong,
/// which is reported.
std::shared_ptr<const Texture> TextureParam(ParamReader* params, std::string_view name,
                                            const TextureContext& context);

/// A colour as parameters have it: the same everywhere, or a texture's.
class ColorInput {
 public:
  ColorInput(Rgb value = {}) : value_(value) {}  // NOLINT: a colour is an input.
  ColorInput(std::shared_ptr<const Texture> texture, Rgb least, Rgb most);

  /// Like the calls of `ParamReader` of these names, but for a texture, which `name texture WORD`
  /// asks for; what it says beyond the legal range is taken as the end of that.
  static ColorInput Color(ParamReader* params, std::string_view name, Rgb default_value,
                          const TextureContext& context);
  static ColorInput Albedo(ParamReader* params, std::string_view name, Rgb default_value,
                           const TextureContext& context);

  Rgb At(const SurfacePoint& point) const { return texture_ ? Textured(point) : value_; }
  bool IsTextured() const { return texture_ != nullptr; }
  bool NeedsTextureCoordinates() const { return texture_ && texture_->NeedsTextureCoordinates(); }
  /// Of a colour that is the same everywhere.
  Rgb value() const { return value_; }

 private:
  Rgb Textured(const SurfacePoint& point) const;

  Rgb value_;
  std::shared_ptr<const Texture> texture_;
  Rgb least_, most_;
};

/// The same for a number, which is the mean of a texture's three.
class NumberInput {
 public:
  NumberInput(float value = 0) : value_(value) {}  // NOLINT: a number is an input.
  explicit NumberInput(std::shared_ptr<const Texture> texture) : texture_(std::move(texture)) {}

  /// From 0 to 1.
  static NumberInput Fraction(ParamReader* params, std::string_view name, float default_value,
                              const TextureContext& context);

  float At(const SurfacePoint& point) const { return texture_ ? Textured(point) : value_; }
  bool IsTextured() const { return texture_ != nullptr; }
  bool NeedsTextureCoordinates() const { return texture_ && texture_->NeedsTextureCoordinates(); }
  /// Of a number that is the same everywhere.
  float value() const { return value_; }

 private:
  float Textured(const SurfacePoint& point) const;

  float value_ = 0;
  std::shared_ptr<const Texture> texture_;
};

}  // namespace candela
