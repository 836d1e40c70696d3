#include "materials/retroreflector_lobe.h"

#include "materials/conductor_lobe.h"

namespace candela {

Spectrum EvalRetroreflector(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  return EvalConductor(lobe, MirrorDirection(wo), wi);
}

float RetroreflectorPdf(const Lobe& lobe, Vec3 wo, Vec3 wi) {
  return ConductorPdf(lobe, MirrorDirection(wo), wi);
}

LobeSample SampleRetroreflector(const Lobe& lobe, Vec3 wo, Vec2 u) {
  return SampleConductor(lobe, MirrorDirection(wo), u);
}

}  // namespace candela
