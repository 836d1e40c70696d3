// What glass gives back of the light it gets, ground, dispersive and under films: all of it.

#include <gtest/gtest.h>

#include <optional>

#include "materials/conductor.h"
#include "materials/dielectric.h"
#include "materials/pane.h"
#include "math/wavelength.h"
#include "tests/materials/white_furnace.h"

namespace candela::test {
namespace {

DielectricMaterial Glass(float ior, float alpha) {
  return {{ior, {}}, Roughness::OfAlpha(alpha)};
}

// P4
TEST(WhiteFurnace, SmoothGlassAndPanesLoseNothing) {
  for (const bool is_outside : {true, false}) {
    ExpectWhite(Glass(1.5f, 0), 1e-6, is_outside);
    ExpectWhite(PaneMaterial(1.5f, {}), 1e-6, is_outside);
  }
}

// P4
TEST(WhiteFurnace, GroundGlassLosesNothingFromEitherSide) {
  for (const float alpha : kAlphas) {
    ExpectWhite(Glass(1.5f, alpha), 3e-3, true);
    ExpectWhite(Glass(1.5f, alpha), 3e-3, false);
  }
  ExpectWhite(Glass(2.417f, 0.3f), 3e-3, true);
  ExpectWhite(Glass(2.417f, 0.3f), 3e-3, false);
}

constexpr float kWavelengths[] = {kShortestWavelength, 450, 530, Dispersion::kYellow,
                                  kLongestWavelength};

/// A boundary between two media, as light of one wavelength or, for 0, of all meets it.
Bsdf BsdfBetween(const Material& material, const Medium& here, const Medium& beyond,
                 float wavelength) {
  SurfacePoint point;
  point.n_geometric = point.n_shading = kNormal;
  Bsdf bsdf;
  bsdf.frame = Frame::FromNormal(kNormal);
  bsdf.wavelength = wavelength;
  bsdf.medium_here = &here;
  bsdf.medium_beyond = &beyond;
  material.Evaluate(point, &bsdf);
  return bsdf;
}

/// Light of each wavelength finds glass that disperses white, ground and under a film or not, also
/// between two media.
void ExpectWhiteForEachWavelength(float alpha, const std::optional<FilmInput>& film) {
  const Medium glass{1.5f, {}, Dispersion::OfAbbeNumber(1.5f, 2)};
  const Medium oil{1.3f, {}, Dispersion::OfAbbeNumber(1.3f, 4)};
  const Medium media[] = {kAir, glass, oil};
  const DielectricMaterial material(glass, Roughness::OfAlpha(alpha), media, film);
  const Medium* const pairs[][2] = {{&kAir, &glass}, {&glass, &kAir}, {&glass, &oil}};
  for (const auto& [here, beyond] : pairs) {
    for (const float wavelength : kWavelengths) {
      SCOPED_TRACE(testing::Message() << alpha << ", " << here->ior << ", " << wavelength);
      ExpectWhite(BsdfBetween(material, *here, *beyond, wavelength), 4e-3);
    }
  }
}

// P4: each wavelength has the energies of its own index.
TEST(WhiteFurnace, GroundGlassThatDispersesLosesNothingOfAnyColour) {
  for (const float alpha : {0.1f, 0.5f, 1.0f}) ExpectWhiteForEachWavelength(alpha, std::nullopt);
}

// P4: and of its own reflectance, which a film makes another one for each.
TEST(WhiteFurnace, FilmsOnGroundGlassThatDispersesLoseNothingOfAnyColour) {
  ExpectWhiteForEachWavelength(0.5f, FilmInput(3, 150));
  ExpectWhiteForEachWavelength(1, FilmInput(1.5f, 150));
  ExpectWhiteForEachWavelength(1, FilmInput(2, 400));
}

// P4: media may have the same index for yellow light and others for the rest, which sees facets.
TEST(WhiteFurnace, GroundGlassInGlassThatDispersesOtherwiseIsRough) {
  const Medium glass{1.5f, {}, Dispersion::OfAbbeNumber(1.5f, 20)}, plain{1.5f, {}};
  const Medium media[] = {kAir, glass, plain};
  const DielectricMaterial material(glass, Roughness::OfAlpha(0.5f), media);
  const Medium* const pairs[][2] = {{&glass, &plain}, {&plain, &glass}};
  for (const auto& [here, beyond] : pairs) {
    for (const float wavelength : kWavelengths) {
      SCOPED_TRACE(testing::Message() << here->dispersion.IsNone() << ", " << wavelength);
      const Bsdf bsdf = BsdfBetween(material, *here, *beyond, wavelength);
      const bool is_yellow = wavelength == Dispersion::kYellow;
      EXPECT_EQ(IsDelta(bsdf.lobes[0].kind), is_yellow);
      ExpectWhite(bsdf, 4e-3);
    }
  }
}

// P4: a film reflects also between equal media, and on facets as these are turned.
TEST(WhiteFurnace, RoughFilmsBetweenEqualMediaAreRoughAndLoseNothing) {
  const Medium glass{1.5f, {}, Dispersion::OfAbbeNumber(1.5f, 20)}, plain{1.5f, {}};
  const Medium media[] = {kAir, glass, plain};
  const FilmInput film(3, 150);
  const Medium* const pairs[][2] = {
      {&kAir, &kAir}, {&glass, &glass}, {&glass, &plain}, {&plain, &glass}};
  const DielectricMaterial material({1, {}}, Roughness::OfAlpha(0.5f), media, film);
  for (const auto& [here, beyond] : pairs) {
    for (const float wavelength : {0.0f, 450.0f, Dispersion::kYellow}) {
      SCOPED_TRACE(testing::Message() << here->ior << ", " << wavelength);
      const Bsdf bsdf = BsdfBetween(material, *here, *beyond, wavelength);
      EXPECT_FALSE(IsDelta(bsdf.lobes[0].kind));
      ExpectWhite(bsdf, 4e-3);
      const Vec3 mirrored = DirectionAt(bsdf.frame, 30, 180);
      EXPECT_GT(Eval(bsdf, DirectionAt(bsdf.frame, 30, 0), mirrored)[1], 0.01f);
    }
  }
  ExpectWhite(material, 4e-3, true);
  ExpectWhite(material, 4e-3, false);
}

// P4: a film that absorbs nothing sends back or lets through what the base does not.
TEST(WhiteFurnace, ThinFilmsLoseNothing) {
  const FilmInput film(2.2f, 150);
  for (const float alpha : {0.0f, 0.1f, 0.5f, 1.0f}) {
    ExpectWhite(ConductorMaterial({0, 0, 0}, {3, 3, 3}, Roughness::OfAlpha(alpha), film), 2e-3);
    const DielectricMaterial glass({1.5f, {}}, Roughness::OfAlpha(alpha), {}, film);
    ExpectWhite(glass, 3e-3, true);
    ExpectWhite(glass, 3e-3, false);
  }
  ExpectWhite(ConductorMaterial({0, 0, 0}, {3, 3, 3}, {0.5f, 0.1f}, 30, film), 2e-3);
}

}  // namespace
}  // namespace candela::test
