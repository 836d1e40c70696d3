#include "textures/uv_transform.h"

#include "math/elementary.h"

namespace candela {

UvTransform UvTransform::Create(ParamReader* params) {
  UvTransform transform;
  const Vec2 scale = params->Pair("scale", {1, 1});
  const auto degrees = static_cast<double>(params->Number("rotation", 0));
  const auto c = static_cast<float>(CosDegrees(degrees));
  const auto s = static_cast<float>(SinDegrees(degrees));
  transform.u_ = {c * scale.x, -s * scale.y};
  transform.v_ = {s * scale.x, c * scale.y};
  transform.offset_ = params->Pair("offset", {0, 0});
  return transform;
}

}  // namespace candela
