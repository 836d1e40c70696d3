#pragma once

#include <algorithm>
#include <cstdint>

#include "materials/ggx.h"
#include "math/spectrum.h"
#include "math/vec.h"
#include "sampling/direction_numbers.h"

namespace candela {

class EnergyTable;
class FilmTable;
class PrincipledLayers;

/// What a surface can do with light: a closed list, since transport dispatches on it.
enum class LobeKind : uint8_t {
  kLambert,           ///< Ideally diffuse: the same radiance in all directions of the upper side.
  kOrenNayar,         ///< Diffuse with roughness.
  kPhong,             ///< A power of the cosine to the mirrored direction, normalised.
  kMirror,            ///< Reflects the weight, whatever the angle.
  kSmoothConductor,   ///< Polished metal.
  kConductor,         ///< Rough metal.
  kSmoothDielectric,  ///< Polished glass: reflects and refracts.
  kDielectric,        ///< Ground glass.
  kPane,              ///< A thin sheet of polished glass, which shifts nothing.
  kPlastic,           ///< A diffuse base under a polished or rough coat of dielectric.
  kHole,              ///< Nothing is there: light goes on as it came.
  kRetroreflector,    ///< Sends light back to where it came from.
  kPrincipled,        ///< Metal and a coated ground, finely mixed, under a coat, under fuzz.
};

struct OrenNayarParams {
  float roughness;  ///< From 0 to 1.
};

struct PhongLobeParams {
  float exponent;
};

/// A thin clear film on a surface.
struct FilmParams {
  const FilmTable* table;  ///< Null where there is none.
  float row;               ///< Of its thickness.
  /// Of light of one wavelength, in nanometres, or 0; it is not looked up: the indices of the film
  /// and of the side with the lower one, and the thickness in nanometres.
  float wavelength, ior, outside, thickness;
};

struct ConductorParams {
  Rgb eta, k;        ///< The complex refractive index eta + i k.
  Rgb mean_fresnel;  ///< The reflectance for diffuse light.
  Ggx surface;
  float cos_rotation, sin_rotation;  ///< Of the direction of `alpha_x` in the frame.
  const EnergyTable* energy;         ///< Of what a white metal reflects after one bounce.
  float table_row;                   ///< Of one that is not brushed.
  bool is_brushed;                   ///< The rows of the table are azimuths.
  FilmParams film;
};

struct DielectricParams {
  float eta;  ///< The refractive index beyond the surface over that on the side of `wo`.
  Ggx surface;
  /// Of what is reflected or let through after one bounce, for light from either side. Where there
  /// is a film, each is the middle one of three, for red, green and blue.
  const EnergyTable *energy_here, *energy_beyond;
  float table_row;
  FilmParams film;
  /// For one wavelength of glass that disperses much: what is between those tables and these, of
  /// the next index that has some, `next_part` of the way. Else there are none, and that is 0.
  const EnergyTable *next_here, *next_beyond;
  float next_part;
};

struct PaneParams {
  float ior;
  Rgb depth;  ///< The optical depth of a straight way through the pane, inside.
};

struct PlasticParams {
  float eta;  ///< The refractive index of the coat.
  Ggx surface;
  float mean_share;           ///< Of diffuse light from outside the part that the coat reflects,
  const EnergyTable* energy;  ///< and, where it is rough, of light from each direction.
  float table_row;
};

struct PrincipledParams {
  const PrincipledLayers* layers;
  Ggx surface;            ///< Of metal and dielectric.
  Rgb specular;           ///< Multiplies what the dielectric mirrors; each from 0 to 1.
  Rgb sheen;              ///< The colour of the fuzz; each from 0 to 1.
  float metallic;         ///< The share of metal.
  float coat;             ///< The share that is coated,
  float coat_alpha;       ///< the roughness of the coat,
  float sheen_roughness;  ///< and of the fuzz.
  float row, brushing;    ///< The `Place` of metal and dielectric in their tables.
  float coat_row;         ///< Of the table of the coat.
  float sin_rotation;     ///< Of the brushing, in the frame, with the cosine that `layers` have.
  /// Multiplies what the layers above let through to the ground, and what is missing after one
  /// bounce on metal, of light from either direction.
  Rgb ground, multiple;
};

/// One part of what a surface does with light: `kind` says which of the structures counts. The
/// weight is the albedo of diffuse ones, of the base of plastic and of the mirror, the base colour
/// of `kPrincipled`, and what a dielectric leaves of light that goes through; it multiplies what
/// others do.
struct Lobe {
  LobeKind kind;
  float pick;  ///< How often it is drawn, in relation to that of the other lobes; not negative.
  float share = 1;  ///< In a mixture of surfaces that of the lobe's; multiplies all it does.
  Spectrum weight;
  /// By kind; of the others there are none.
  union {
    float no_params;
    OrenNayarParams oren_nayar;
    PhongLobeParams phong;
    ConductorParams conductor;
    DielectricParams dielectric;
    PaneParams pane;
    PlasticParams plastic;
    PrincipledParams principled;
  };

  Lobe() : Lobe(LobeKind::kLambert, 1, Spectrum()) {}
  Lobe(LobeKind lobe_kind, float lobe_pick, const Spectrum& lobe_weight)
      : kind(lobe_kind), pick(lobe_pick), weight(lobe_weight), no_params(0) {}
};

/// True for lobes that send light from one direction into one direction, or into two.
constexpr bool IsDelta(LobeKind kind) {
  return kind == LobeKind::kMirror || kind == LobeKind::kSmoothConductor ||
         kind == LobeKind::kSmoothDielectric || kind == LobeKind::kPane || kind == LobeKind::kHole;
}

/// True for lobes that send light to the other side as well.
constexpr bool LetsThrough(LobeKind kind) {
  return kind == LobeKind::kSmoothDielectric || kind == LobeKind::kDielectric ||
         kind == LobeKind::kPane || kind == LobeKind::kHole;
}

/// A direction drawn from a lobe; see `BsdfSample`, whose terms it has.
struct LobeSample {
  Vec3 wi;
  Spectrum weight;
  float pdf = 0;
  bool is_delta = false;
  float eta = 1;
};

// Directions are those of a frame whose z axis is the normal, and `wo` has a z above 0; a `wi` with
// a negative z is on the other side. The values of diffuse lobes are 0 there.

// By reference: packed into registers they would have to wait for what has just been computed.

Spectrum EvalLobe(const Lobe& lobe, const Vec3& wo, const Vec3& wi);
float LobePdf(const Lobe& lobe, const Vec3& wo, const Vec3& wi);
/// Both, in less time where they have a part in common.
struct LobeValue {
  Spectrum value;
  float pdf;
};
LobeValue EvalLobeWithPdf(const Lobe& lobe, const Vec3& wo, const Vec3& wi);
LobeSample SampleLobe(const Lobe& lobe, const Vec3& wo, const DirectionNumbers& numbers);

/// The direction in which a mirror in the plane z = 0 throws light.
constexpr Vec3 MirrorDirection(Vec3 w) {
  return {-w.x, -w.y, w.z};
}

/// Splits a number in [0, 1) at `share`: true with that probability, and `*u` is again a number in
/// [0, 1) with no relation to the answer.
inline bool SplitChoice(float share, float* u) {
  constexpr float kBelowOne = 0x1.fffffep-1f;
  if (*u < share) {
    *u = std::min(*u / share, kBelowOne);
    return true;
  }
  *u = std::min((*u - share) / (1 - share), kBelowOne);
  return false;
}

}  // namespace candela
