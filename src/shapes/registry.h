#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "scene_spec/param_reader.h"
#include "shapes/shape.h"
#include "shapes/shape_context.h"

namespace candela {

/// A kind of shape that scenes may name.
struct ShapeEntry {
  std::string_view name;
  /// Reads the parameters. Returns null when the shape is to be left out; why has been reported.
  std::shared_ptr<const Shape> (*create)(ParamReader* params, ShapeContext* context);
  /// An object body that the contract tests and the manual use.
  std::string_view example;
};

std::span<const ShapeEntry> ShapeEntries();

/// Creates the shape that `spec` describes; null when that failed or it is to be left out.
std::shared_ptr<const Shape> CreateShape(const TypedSpec& spec, ShapeContext* context);

}  // namespace candela
