#include "materials/bsdf.h"

#include <cmath>

namespace candela {
namespace {

/// The place of the lobe that `*u` chooses; `*u` is afterwards as good as new.
int ChooseLobe(const Bsdf& bsdf, float* u) {
  float left = bsdf.pick_sum;
  for (int i = 0; i + 1 < bsdf.count; ++i) {
    if (SplitChoice(bsdf.lobes[i].pick / left, u)) return i;
    left -= bsdf.lobes[i].pick;
  }
  return bsdf.count - 1;
}

/// Adds to a direction that one lobe has drawn what the others do with it.
void AddOthers(const Bsdf& bsdf, const Vec3& wo, int drawn, LobeSample* sample) {
  const float cosine = std::abs(sample->wi.z);
  float pdf = bsdf.lobes[drawn].pick * sample->pdf;
  Spectrum value = sample->weight * sample->pdf;
  for (int i = 0; i < bsdf.count; ++i) {
    if (i == drawn) continue;
    const LobeValue other = EvalLobeWithPdf(bsdf.lobes[i], wo, sample->wi);
    pdf += bsdf.lobes[i].pick * other.pdf;
    value += other.value * (bsdf.lobes[i].share * cosine);
  }
  sample->pdf = pdf / bsdf.pick_sum;
  sample->weight = value * (1 / sample->pdf);
}

// Both of directions in the frame of the Bsdf.

Spectrum EvalLocal(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi) {
  Spectrum sum;
  for (int lobe = 0; lobe < bsdf.count; ++lobe) {
    sum += EvalLobe(bsdf.lobes[lobe], wo, wi) * bsdf.lobes[lobe].share;
  }
  return sum;
}

float PdfLocal(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi) {
  if (!(bsdf.pick_sum > 0)) return 0;
  float sum = 0;
  for (int lobe = 0; lobe < bsdf.count; ++lobe) {
    sum += bsdf.lobes[lobe].pick * LobePdf(bsdf.lobes[lobe], wo, wi);
  }
  return sum / bsdf.pick_sum;
}

}  // namespace

Spectrum Eval(const Bsdf& bsdf, Vec3 wo, Vec3 wi) {
  return EvalLocal(bsdf, bsdf.frame.ToLocal(wo), bsdf.frame.ToLocal(wi));
}

float Pdf(const Bsdf& bsdf, Vec3 wo, Vec3 wi) {
  return PdfLocal(bsdf, bsdf.frame.ToLocal(wo), bsdf.frame.ToLocal(wi));
}

BsdfValue EvalWithPdf(const Bsdf& bsdf, Vec3 wo, Vec3 wi) {
  const Vec3 o = bsdf.frame.ToLocal(wo), i = bsdf.frame.ToLocal(wi);
  Spectrum value;
  float pdf = 0;
  for (int lobe = 0; lobe < bsdf.count; ++lobe) {
    const LobeValue part = EvalLobeWithPdf(bsdf.lobes[lobe], o, i);
    value += part.value * bsdf.lobes[lobe].share;
    pdf += bsdf.lobes[lobe].pick * part.pdf;
  }
  return {value, bsdf.pick_sum > 0 ? pdf / bsdf.pick_sum : 0};
}

BsdfSample Sample(const Bsdf& bsdf, Vec3 wo, DirectionNumbers numbers) {
  if (!(bsdf.pick_sum > 0)) return {};
  const Vec3 o = bsdf.frame.ToLocal(wo);
  int drawn = 0;
  if (bsdf.count > 1) {
    Vec2 u = numbers.u();
    drawn = ChooseLobe(bsdf, &u.x);
    numbers = u;
  }
  if (!(bsdf.lobes[drawn].pick > 0)) return {};  // By rounding only.
  const LobeKind kind = bsdf.lobes[drawn].kind;
  // A bent normal may look away; holes do not ask for it.
  if (!(o.z > 0) && kind != LobeKind::kHole) return {};
  LobeSample sample = SampleLobe(bsdf.lobes[drawn], o, numbers);
  if (sample.pdf == 0) return {};
  sample.weight *= Spectrum(bsdf.lobes[drawn].share);
  if (sample.is_delta) {
    const float choice = bsdf.lobes[drawn].pick / bsdf.pick_sum;
    sample.pdf *= choice;
    sample.weight *= Spectrum(1 / choice);
  } else if (bsdf.count > 1) {
    AddOthers(bsdf, o, drawn, &sample);
  }
  const bool is_transmission = sample.wi.z < 0;
  return {bsdf.frame.ToWorld(sample.wi),
          sample.weight,
          sample.pdf,
          sample.is_delta,
          is_transmission,
          is_transmission && kind != LobeKind::kHole && kind != LobeKind::kPane,
          kind == LobeKind::kHole,
          sample.eta};
}

}  // namespace candela
