#include "lights/falloff.h"

namespace candela {

Falloff Falloff::Read(ParamReader* params) {
  if (!params->Has("falloff")) return params->Positive("attenuation", 20);
  if (params->Has("attenuation")) {
    // Asked for all the same, so that what is wrong with it is said in the same run.
    params->Positive("attenuation", 20);
    params->Error(params->Where("falloff"),
                  "a light has an 'attenuation' or a 'falloff', not both");
  }
  const Vec3 parts = params->NonNegativeColor("falloff", {0, 0, 20});
  if (parts == Vec3()) {
    params->Error(params->Where("falloff"),
                  "'falloff' expects three numbers that are not negative, not all of them 0");
    return 20;
  }
  return {parts.x, parts.y, parts.z};
}

}  // namespace candela
