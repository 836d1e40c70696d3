#include "materials/lobe.h"

#include "materials/conductor_lobe.h"
#include "materials/dielectric_lobe.h"
#include "materials/diffuse_lobes.h"
#include "materials/plastic_lobe.h"
#include "materials/principled_lobe.h"
#include "materials/retroreflector_lobe.h"
#include "sampling/warp.h"

namespace candela {
namespace {

/// The only direction there is, with all the light.
LobeSample SampleSingle(const Lobe& lobe, Vec3 wi) {
  LobeSample sample;
  sample.wi = wi;
  sample.weight = lobe.weight;
  sample.pdf = 1;
  sample.is_delta = true;
  return sample;
}

/// Whether any smooth light goes from one direction to the other.
bool IsLit(const Lobe& lobe, const Vec3& wo, const Vec3& wi) {
  return wo.z > 0 && (wi.z > 0 || (wi.z < 0 && lobe.kind == LobeKind::kDielectric));
}

}  // namespace

Spectrum EvalLobe(const Lobe& lobe, const Vec3& wo, const Vec3& wi) {
  if (!IsLit(lobe, wo, wi)) return {};
  switch (lobe.kind) {
    case LobeKind::kLambert:
      return EvalLambert(lobe);
    case LobeKind::kOrenNayar:
      return EvalOrenNayar(lobe, wo, wi);
    case LobeKind::kPhong:
      return EvalPhong(lobe, wo, wi);
    case LobeKind::kConductor:
      return EvalConductor(lobe, wo, wi);
    case LobeKind::kDielectric:
      return EvalDielectric(lobe, wo, wi);
    case LobeKind::kPlastic:
      return EvalPlastic(lobe, wo, wi);
    case LobeKind::kRetroreflector:
      return EvalRetroreflector(lobe, wo, wi);
    case LobeKind::kPrincipled:
      return EvalPrincipled(lobe, wo, wi);
    case LobeKind::kMirror:
    case LobeKind::kSmoothConductor:
    case LobeKind::kSmoothDielectric:
    case LobeKind::kPane:
    case LobeKind::kHole:
      break;
  }
  return {};
}

float LobePdf(const Lobe& lobe, const Vec3& wo, const Vec3& wi) {
  if (!IsLit(lobe, wo, wi)) return 0;
  switch (lobe.kind) {
    case LobeKind::kLambert:
      return CosineHemispherePdf(wi.z);
    case LobeKind::kOrenNayar:
      return OrenNayarPdf(lobe, wo, wi);
    case LobeKind::kPhong:
      return PhongPdf(lobe, wo, wi);
    case LobeKind::kConductor:
      return ConductorPdf(lobe, wo, wi);
    case LobeKind::kDielectric:
      return DielectricPdf(lobe, wo, wi);
    case LobeKind::kPlastic:
      return PlasticPdf(lobe, wo, wi);
    case LobeKind::kRetroreflector:
      return RetroreflectorPdf(lobe, wo, wi);
    case LobeKind::kPrincipled:
      return PrincipledPdf(lobe, wo, wi);
    case LobeKind::kMirror:
    case LobeKind::kSmoothConductor:
    case LobeKind::kSmoothDielectric:
    case LobeKind::kPane:
    case LobeKind::kHole:
      break;
  }
  return 0;
}

LobeValue EvalLobeWithPdf(const Lobe& lobe, const Vec3& wo, const Vec3& wi) {
  if (lobe.kind == LobeKind::kPrincipled) {
    return IsLit(lobe, wo, wi) ? EvalPrincipledWithPdf(lobe, wo, wi) : LobeValue{{}, 0};
  }
  return {EvalLobe(lobe, wo, wi), LobePdf(lobe, wo, wi)};
}

LobeSample SampleLobe(const Lobe& lobe, const Vec3& wo, const DirectionNumbers& numbers) {
  const Vec2 u = numbers.u();
  switch (lobe.kind) {
    case LobeKind::kLambert:
      return SampleLambert(lobe, numbers);
    case LobeKind::kOrenNayar:
      return SampleOrenNayar(lobe, wo, u);
    case LobeKind::kPhong:
      return SamplePhong(lobe, wo, u);
    case LobeKind::kMirror:
      return SampleSingle(lobe, MirrorDirection(wo));
    case LobeKind::kSmoothConductor:
      return SampleSmoothConductor(lobe, wo);
    case LobeKind::kConductor:
      return SampleConductor(lobe, wo, u);
    case LobeKind::kSmoothDielectric:
      return SampleSmoothDielectric(lobe, wo, u);
    case LobeKind::kDielectric:
      return SampleDielectric(lobe, wo, u);
    case LobeKind::kPane:
      return SamplePane(lobe, wo, u);
    case LobeKind::kPlastic:
      return SamplePlastic(lobe, wo, u);
    case LobeKind::kHole:
      return SampleSingle(lobe, -wo);
    case LobeKind::kRetroreflector:
      return SampleRetroreflector(lobe, wo, u);
    case LobeKind::kPrincipled:
      return SamplePrincipled(lobe, wo, u);
  }
  return {};
}

}  // namespace candela
