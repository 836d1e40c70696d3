#pragma once

#include "textures/texture_context.h"

namespace candela {

/// What a material may ask for while it is created.
struct MaterialContext : TextureContext {};

}  // namespace candela
