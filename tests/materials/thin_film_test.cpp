// Interference in thin films: closed forms at one wavelength, and the colours that tables hold.
#include "materials/thin_film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "materials/conductor.h"
#include "materials/conductor_lobe.h"
#include "materials/dielectric.h"
#include "materials/energy_store.h"
#include "materials/fresnel.h"
#include "math/wavelength.h"
#include "tests/materials/scatter.h"
#include "textures/constant_texture.h"

namespace candela {
namespace {

constexpr double kCosines[] = {1, 0.9, 0.7, 0.5, 0.3, 0.1, 0.02};
constexpr double kWavelength = 550;

double Bare(double cosine, double eta) {
  float beyond;
  return double{
      DielectricReflectance(static_cast<float>(cosine), static_cast<float>(eta), &beyond)};
}

// A quarter of a wave of magnesium fluoride on glass: R = ((n0 ns - n1^2) / (n0 ns + n1^2))^2.
TEST(ThinFilm, OfAQuarterWaveIsAnAntireflectionCoating) {
  const double n1 = 1.38, ns = 1.52;
  const double quarter = kWavelength / (4 * n1);
  const double amplitude = (ns - n1 * n1) / (ns + n1 * n1);
  EXPECT_NEAR(FilmReflectance({n1, {ns, 0}}, quarter, kWavelength, 1), amplitude * amplitude,
              1e-12);
  EXPECT_NEAR(FilmReflectance({n1, {ns, 0}}, 3 * quarter, kWavelength, 1), amplitude * amplitude,
              1e-12);
  // The index in between makes it invisible.
  const double between = std::sqrt(ns);
  EXPECT_NEAR(FilmReflectance({between, {ns, 0}}, kWavelength / (4 * between), kWavelength, 1), 0,
              1e-12);
}

// Half of a wave is as good as nothing, at any angle if it is as thick as that asks for.
TEST(ThinFilm, OfHalfAWaveIsInvisible) {
  for (const double cosine : kCosines) {
    const double along = std::sqrt(1.8 * 1.8 - (1 - cosine * cosine));
    EXPECT_NEAR(FilmReflectance({1.8, {1.5, 0}}, kWavelength / (2 * along), kWavelength, cosine),
                Bare(cosine, 1.5), 1e-6)
        << cosine;
  }
}

// A free film, of the index n in air: R = F s^2 / (1 + F s^2) with F = 4 R1 / (1 - R1)^2, where s
// is the sine of half of the phase.
TEST(ThinFilm, InAirHasTheReflectanceOfAnEtalon) {
  const double n = 1.333, r1 = std::pow((n - 1) / (n + 1), 2), f = 4 * r1 / std::pow(1 - r1, 2);
  for (const double thickness : {30.0, 100.0, 333.0, 1200.0}) {
    const double sine = Sin(2 * kPi * n * thickness / kWavelength);
    EXPECT_NEAR(FilmReflectance({n, {1, 0}}, thickness, kWavelength, 1),
                f * sine * sine / (1 + f * sine * sine), 1e-12)
        << thickness;
  }
}

TEST(ThinFilm, WithoutThicknessOrContrastIsTheBareSurface) {
  for (const double cosine : kCosines) {
    EXPECT_NEAR(FilmReflectance({1.8, {1.5, 0}}, 0, kWavelength, cosine), Bare(cosine, 1.5), 1e-6);
    EXPECT_NEAR(FilmReflectance({1, {1.5, 0}}, 300, kWavelength, cosine), Bare(cosine, 1.5), 1e-6);
    EXPECT_NEAR(FilmReflectance({1.5, {1.5, 0}}, 300, kWavelength, cosine), Bare(cosine, 1.5),
                1e-6);
    const Rgb metal = ConductorReflectance(static_cast<float>(cosine), Rgb{0.2f, 0.9f, 2.7f},
                                           Rgb{3.9f, 2.4f, 3.8f});
    EXPECT_NEAR(FilmReflectance({1.8, {0.2f, 3.9f}}, 0, kWavelength, cosine), metal.x, 1e-6);
    EXPECT_NEAR(FilmReflectance({1, {0.9f, 2.4f}}, 300, kWavelength, cosine), metal.y, 1e-6);
    EXPECT_NEAR(FilmReflectance({2.7, {2.7f, 3.8f}}, 0, kWavelength, cosine), metal.z, 1e-6);
  }
}

/// The way through a film from the other side: light in the base, whose index is the larger one.
double FromBeyond(double film, double base, double thickness, double cosine_outside) {
  const double sine = std::sqrt(1 - cosine_outside * cosine_outside) / base;
  return FilmReflectance({film / base, {1 / base, 0}, base}, thickness, kWavelength,
                         std::sqrt(1 - sine * sine));
}

// What is reflected and what gets through make 1, and as much gets through from either side: so a
// film of any index reflects as much of the light inside. Also of one that light can only tunnel
// through, with an index below both.
TEST(ThinFilm, ReflectsTheSameFromBothSides) {
  for (const double film : {0.7, 1.2, 1.4, 2.4}) {
    for (const double thickness : {50.0, 200.0, 700.0}) {
      for (const double cosine : kCosines) {
        EXPECT_NEAR(FilmReflectance({film, {1.5, 0}}, thickness, kWavelength, cosine),
                    FromBeyond(film, 1.5, thickness, cosine), 1e-9)
            << film << ", " << thickness << " nm, " << cosine;
      }
    }
  }
}

TEST(ThinFilm, ReflectsAllBeyondTheCriticalAngleOfTheBase) {
  for (const double film : {0.8, 1.2, 2.4}) {
    for (const double cosine : {0.6, 0.3, 0.05}) {
      EXPECT_NEAR(FilmReflectance({film / 1.5, {1 / 1.5, 0}, 1.5}, 200, kWavelength, cosine), 1,
                  1e-9)
          << film << ", " << cosine;
    }
  }
}

// Where a wave would run along the film or along the base there is a limit, and no division by 0.
TEST(ThinFilm, HasAReflectanceAtItsCriticalAngle) {
  const double cosine = 0.6;  // The sine is 0.8, which is the index of the film.
  const double at = FilmReflectance({0.8, {1.5, 0}}, 100, kWavelength, cosine);
  EXPECT_NEAR(FilmReflectance({0.8, {1.5, 0}}, 100, kWavelength, cosine + 1e-6), at, 1e-4);
  EXPECT_NEAR(FilmReflectance({0.8, {1.5, 0}}, 100, kWavelength, cosine - 1e-6), at, 1e-4);
  EXPECT_EQ(FilmReflectance({1.3, {1.5, 0}}, 100, kWavelength, 0), 1);
}

/// The mean of a colour's response to what a film reflects, by a tenth of the table's steps.
double Colour(const FilmStack& stack, double thickness, double cosine, int c) {
  double sum = 0;
  for (int i = 0; i <= 1200; ++i) {
    const double wavelength = double{kShortestWavelength} + i * 0.25;
    const double weight = double{ResponsesAt(static_cast<float>(wavelength))[c]} * 0.25;
    if (weight > 0) sum += weight * FilmReflectance(stack, thickness, wavelength, cosine);
  }
  return sum;
}

const Rgb kEta{0.2f, 0.9f, 2.7f}, kK{3.9f, 2.4f, 3.8f};

double WorstError(const FilmTable& table, double film, float least, float most) {
  double worst = 0;
  for (int i = 0; i <= 20; ++i) {
    const float thickness = least + (most - least) * static_cast<float>(i) / 20;
    for (const double cosine : kCosines) {
      const auto at = static_cast<float>(cosine);
      const Rgb found = table.Over(ConductorReflectance(at, kEta, kK), at, table.RowOf(thickness));
      for (int c = 0; c < 3; ++c) {
        const FilmStack stack{film, {double{kEta[c]}, double{kK[c]}}};
        const double expected = Colour(stack, double{thickness}, cosine, c);
        worst = std::max(worst, std::abs(double{found[c]} - expected));
      }
    }
  }
  return worst;
}

TEST(FilmTable, HoldsTheMeansOverWavelengths) {
  for (const double film : {1.01, 1.333, 2.4}) {
    EXPECT_LT(WorstError({film, 1, kEta, kK, 0, 600}, film, 0, 600), 2e-3) << film;
    EXPECT_LT(WorstError({film, 1, kEta, kK, 1800, 2000}, film, 1800, 2000), 2e-3) << film;
    EXPECT_LT(WorstError({film, 1, kEta, kK, 300, 300}, film, 300, 300), 1e-3) << film;
  }
}

// Where waves go through the film, and where they only fade in it, which tables sum up differently.
// At their own cosines, as there is a kink between the two.
TEST(FilmTable, HoldsThemOnBothSidesOfTheCriticalAngle) {
  const double film = 0.8;
  for (const float thickness : {50.0f, 200.0f, 600.0f}) {
    const FilmTable table(film, 1, kEta, kK, thickness, thickness);
    for (const double column : {30, 70, 98, 100, 110, 120}) {
      const double cosine = std::pow(column / 128, 2);
      const auto at = static_cast<float>(cosine);
      const Rgb found = table.Over(ConductorReflectance(at, kEta, kK), at, 0);
      for (int c = 0; c < 3; ++c) {
        const FilmStack stack{film, {double{kEta[c]}, double{kK[c]}}};
        EXPECT_NEAR(found[c], Colour(stack, double{thickness}, cosine, c), 1e-4)
            << cosine << ", " << thickness;
      }
    }
  }
}

TEST(FilmTable, ChangesNothingWithoutThicknessOrContrast) {
  const FilmTable range(1.8, 1, kEta, kK, 0, 400);
  const FilmTable as_outside(1, 1, kEta, kK, 300, 300);
  const FilmTable as_base(1.5, 1, {1.5f, 1.5f, 1.5f}, {0, 0, 0}, 300, 300);
  for (const double cosine : kCosines) {
    const auto at = static_cast<float>(cosine);
    EXPECT_EQ(range.At(at, range.RowOf(0)), Rgb());
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(as_outside.At(at, 0)[c], 0, 1e-7f);
      EXPECT_NEAR(as_base.At(at, 0)[c], 0, 1e-7f);
    }
  }
  EXPECT_EQ(range.Mean(0), Rgb());
}

// `Over` cuts at 1, so what a metal reflects that absorbs nothing shows no gain: this does.
TEST(FilmTable, ChangesNothingOnMetalThatAbsorbsNothing) {
  for (const float k : {0.5f, 3.0f}) {
    for (const double film : {1.4, 2.2}) {
      const FilmTable table(film, 1, {0, 0, 0}, {k, k, k}, 50, 450);
      for (const double cosine : kCosines) {
        for (int i = 0; i <= 20; ++i) {
          const Rgb change =
              table.At(static_cast<float>(cosine), table.RowOf(50 + 20 * static_cast<float>(i)));
          for (int c = 0; c < 3; ++c) EXPECT_NEAR(change[c], 0, 1e-6f) << film << ", " << cosine;
        }
      }
    }
  }
}

// Along the surface all light is reflected: by the base, and between equal media by the film alone.
TEST(FilmTable, ReflectsAllAtTheHorizon) {
  const FilmTable bubble(1.333, 1, {1, 1, 1}, {0, 0, 0}, 0, 400);
  for (const float cosine : {0.0f, 1e-6f, 2e-5f}) {
    const Rgb reflected = bubble.Over({0, 0, 0}, cosine, bubble.RowOf(300));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(reflected[c], 1, 0.02f) << cosine;
    EXPECT_EQ(bubble.At(cosine, 0), Rgb()) << cosine;
  }
  // 1.45f times its inverse is not 1.
  const auto in_oil = FilmInput(1.6f, 300).Table(1.45f, {1.45f, 1.45f, 1.45f}, {0, 0, 0}, nullptr);
  EXPECT_NEAR(in_oil->Over({0, 0, 0}, 0, 0).x, 1, 0.02f);
  const FilmTable glass(1.333, 1, {1.5f, 1.5f, 1.5f}, {0, 0, 0}, 300, 300);
  EXPECT_EQ(glass.Over({1, 1, 1}, 0, 0), (Rgb{1, 1, 1}));
}

TEST(FilmTable, KnowsTheMeanOverDirections) {
  const FilmTable table(1.8, 1, kEta, kK, 0, 400);
  const float row = table.RowOf(217);
  Rgb sum;
  for (int i = 0; i < 10000; ++i) {
    sum += table.At(std::sqrt((static_cast<float>(i) + 0.5f) / 10000), row) * 1e-4f;
  }
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(table.Mean(row)[c], sum[c], 1e-4f);
}

float SpreadOf(Rgb c) {
  return std::max(c.x, std::max(c.y, c.z)) - std::min(c.x, std::min(c.y, c.z));
}

// Under a film on glass with dispersion each wavelength has its own reflectance, whose mean over
// all of them is that of colours.
TEST(FilmOnGlass, ReflectsEachWavelengthByItself) {
  const Dispersion none = Dispersion::Cauchy({1.5f - 1e-6f, 1e-7f, 0});
  const FilmInput film(2.2f, 300);
  const DielectricMaterial split({1.5f, {}, none}, Roughness(), {}, film);
  const DielectricMaterial whole({1.5f, {}}, Roughness(), {}, film);
  for (const double degrees : {0.0, 40.0, 75.0}) {
    Rgb mean;
    constexpr int kCount = 3000;
    for (int i = 0; i < kCount; ++i) {
      SurfacePoint point;
      point.n_geometric = point.n_shading = {0, 0, 1};
      Bsdf bsdf;
      bsdf.frame = Frame::FromNormal({0, 0, 1});
      bsdf.wavelength = SampleWavelength((static_cast<float>(i) + 0.5f) / kCount);
      split.Evaluate(point, &bsdf);
      const BsdfSample sample = Sample(bsdf, test::DirectionAt(bsdf.frame, degrees), {0, 0.5f});
      const Spectrum share = sample.weight * sample.pdf * ColourOf(bsdf.wavelength);
      mean += share.ToRgb() * (1.0f / kCount);
    }
    const Bsdf bsdf = test::BsdfOf(whole, {0, 0, 1});
    const BsdfSample sample = Sample(bsdf, test::DirectionAt(bsdf.frame, degrees), {0, 0.5f});
    const Rgb expected = (sample.weight * sample.pdf).ToRgb();
    EXPECT_GT(SpreadOf(expected), 0.02f) << "the film shows no colour";
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], expected[c], 1e-3f) << degrees;
  }
}

/// What a material reflects of light that comes head-on.
Rgb HeadOn(const Material& material) {
  const BsdfSample sample = Sample(test::BsdfOf(material, {0, 0, 1}), Vec3{0, 0, 1}, {0, 0.5f});
  EXPECT_FALSE(sample.is_transmission);
  return (sample.weight * sample.pdf).ToRgb();
}

// A texture goes over the range: of 0 nm, it is the bare material.
TEST(Film, OfATexturedThicknessIsThatOfEachPoint) {
  const auto share = [](float value) {
    return NumberInput(std::make_shared<ConstantTexture>(Rgb{value, value, value}));
  };
  const Roughness smooth;
  const ConductorMaterial bare(kEta, kK, smooth);
  const ConductorMaterial ends(kEta, kK, smooth, FilmInput(1.8f, 0, 400, share(0)));
  EXPECT_EQ(HeadOn(ends), HeadOn(bare));
  const ConductorMaterial middle(kEta, kK, smooth, FilmInput(1.8f, 100, 300, share(0.5f)));
  const ConductorMaterial even(kEta, kK, smooth, FilmInput(1.8f, 200));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(HeadOn(middle)[c], HeadOn(even)[c], 1e-3f);
  EXPECT_EQ(bare.Phong({}).specular, HeadOn(bare));
  EXPECT_EQ(even.Phong({}).specular, HeadOn(even));
}

// Materials that are alike have one table in common, which takes its time.
TEST(Film, OfTheSameKindIsTabulatedOnce) {
  EnergyStore energies;
  const auto share = NumberInput(std::make_shared<ConstantTexture>(Rgb{0.5f, 0.5f, 0.5f}));
  const auto conductor = [&](float most, EnergyStore* store) {
    const ConductorMaterial metal(kEta, kK, Roughness(), FilmInput(1.8f, 0, most, share), store);
    return test::BsdfOf(metal, {0, 0, 1}).lobes[0].conductor.film.table;
  };
  const FilmTable* first = conductor(300, &energies);
  EXPECT_EQ(conductor(300, &energies), first);
  EXPECT_NE(conductor(301, &energies), first);
  const auto glass = [&](float ior) {
    const DielectricMaterial material({ior, {}}, Roughness(), {}, FilmInput(1.8f, 300), &energies);
    return test::BsdfOf(material, {0, 0, 1}).lobes[0].dielectric.film.table;
  };
  EXPECT_EQ(glass(1.5f), glass(1.5f));
  EXPECT_NE(glass(1.5f), glass(1.6f));
}

// A bubble is a film between air and air.
TEST(Film, BetweenEqualMediaIsSeen) {
  const DielectricMaterial bubble({1, {}}, Roughness(), {}, FilmInput(1.333f, 120));
  const Rgb reflected = HeadOn(bubble);
  EXPECT_GT(reflected.y, 0.05f);
  EXPECT_LT(reflected.y, 0.09f);
}

}  // namespace
}  // namespace candela
