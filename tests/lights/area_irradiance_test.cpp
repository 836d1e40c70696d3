// Irradiance from area lights, in closed form: the samplers as a path uses them, without a picture.

#include <gtest/gtest.h>

#include <memory>

#include "lights/area_light.h"
#include "math/elementary.h"
#include "shapes/disk.h"
#include "shapes/mesh.h"
#include "shapes/rectangle.h"
#include "shapes/sphere.h"
#include "shapes/triangle.h"
#include "tests/lights/irradiance.h"

namespace candela {
namespace {

using test::ExpectIrradiance;
using test::IrradianceOf;

constexpr Vec3 kUp{0, 0, 1};

/// A lamp of the given red radiance, its shape moved by a matrix.
class Lamp {
 public:
  Lamp(std::unique_ptr<const Shape> shape, double radiance, const Mat4& place = Mat4::Identity(),
       bool is_two_sided = true)
      : shape_(std::move(shape)),
        light_(Spectrum(Rgb{static_cast<float>(radiance), 0, 0}), is_two_sided) {
    light_.SetSurface(shape_->MakeSampler(Transform(place), Transform(*InverseAffine(place))), {},
                      1);
  }
  const Light& light() const { return light_; }

 private:
  std::unique_ptr<const Shape> shape_;
  AreaLight light_;
};

/// The unit normal at an angle to the direction z, in which the lamp is.
Vec3 Tilted(double degrees) {
  return {static_cast<float>(SinDegrees(degrees)), 0, static_cast<float>(CosDegrees(degrees))};
}

// CF5: E = pi L (R/d)^2 cos, while all of it is above the horizon.
TEST(SphereLight, AboveTheHorizonGivesPiLTimesSquaredSineTimesCosine) {
  const Lamp lamp(std::make_unique<Sphere>(1.0f), 5, Mat4::Translate({0, 0, 3}));
  ExpectIrradiance(lamp.light(), {0, 0, 0}, Tilted(0), 1.745329);
  ExpectIrradiance(lamp.light(), {0, 0, 0}, Tilted(60), 0.872665);
}

// CF5: the same from far away, where only the cone knows how small it is.
TEST(SphereLight, FromFarAwayStillFillsItsCone) {
  const Lamp lamp(std::make_unique<Sphere>(1.0f), 5, Mat4::Translate({0, 0, 3000}));
  ExpectIrradiance(lamp.light(), {0, 0, 0}, Tilted(0), kPi * 5 / 9e6);
}

// CF6: with H = d/R, x = sqrt(H^2 - 1), y = -x / tan b: E = L [(cos b acos y - x sin b sqrt(1 -
// y^2)) / H^2 + atan(sin b sqrt(1 - y^2) / x)].
TEST(SphereLight, CutByTheHorizonGivesTheFormulaOfTheCap) {
  const Lamp lamp(std::make_unique<Sphere>(1.0f), 5, Mat4::Translate({0, 0, 3}));
  for (const double b : {75.0, 80.0, 95.0, 105.0}) {
    const double x = std::sqrt(8.0);
    const double y = -x / TanDegrees(b);
    const double root = std::sqrt(1 - y * y);
    const double expected = 5 * ((CosDegrees(b) * Acos(y) - x * SinDegrees(b) * root) / 9 +
                                 Atan(SinDegrees(b) * root / x));
    if (b == 80.0) {
      EXPECT_NEAR(expected, 0.326109, 1e-6);
    }
    if (b == 95.0) {
      EXPECT_NEAR(expected, 0.063676, 1e-6);
    }
    const auto e = IrradianceOf(lamp.light(), {0, 0, 0}, Tilted(b), 65536);
    EXPECT_LE(std::abs(e.mean - expected), test::kLargestDeviate * e.error + 3e-6 * expected) << b;
    EXPECT_LE(e.error, 1e-3 * expected) << b;
  }
}

TEST(SphereLight, StretchedByItsNodeIsAnEllipsoid) {
  // Squeezed along the line of sight it is an ellipse of semi-axes a and b at distance d, which
  // gives pi L a b / sqrt((d^2 + a^2) (d^2 + b^2)).
  const Mat4 place = Mat4::Translate({0, 0, 300}) * Mat4::Scale({2, 1, 0.001});
  const Lamp lamp(std::make_unique<Sphere>(1.0f), 5, place);
  ExpectIrradiance(lamp.light(), {0, 0, 0}, Tilted(0), kPi * 5 * 2 / std::sqrt(90004.0 * 90001.0));
}

// E = (pi L / 2) [1 - (h^2 + a^2 - R^2) / sqrt((h^2 + a^2 + R^2)^2 - 4 R^2 a^2)].
double UnderADisk(double l, double r, double h, double a) {
  const double sum = h * h + a * a + r * r;
  return kPi * l / 2 * (1 - (sum - 2 * r * r) / std::sqrt(sum * sum - 4 * r * r * a * a));
}

// CF7
TEST(DiskLight, OverAParallelPlaneGivesTheClosedForm) {
  const Lamp lamp(std::make_unique<Disk>(1.0f), 3, Mat4::Translate({0, 0, 2}));
  EXPECT_NEAR(UnderADisk(3, 1, 2, 0), 1.884956, 1e-6);
  EXPECT_NEAR(UnderADisk(3, 1, 2, 1.5), 0.964005, 1e-6);
  ExpectIrradiance(lamp.light(), {0, 0, 0}, kUp, 1.884956);
  ExpectIrradiance(lamp.light(), {1.5f, 0, 0}, kUp, 0.964005);
  ExpectIrradiance(lamp.light(), {0, 5, 0}, kUp, UnderADisk(3, 1, 2, 5));
}

// Nearly touching it, from where all of the sky is disk, no direction weighs more than another.
TEST(DiskLight, FromVeryNearFillsTheSkyWithoutNoise) {
  const Lamp lamp(std::make_unique<Disk>(1.0f), 3, Mat4::Translate({0, 0, 0.01}));
  ExpectIrradiance(lamp.light(), {0.3f, 0.2f, 0}, kUp, UnderADisk(3, 1, 0.01, std::sqrt(0.13)));
}

TEST(FlatLights, NearlyTouchedFillTheSky) {
  for (const double height : {1e-3, 1e-4}) {
    SCOPED_TRACE(height);
    const Mat4 place = Mat4::Translate({0, 0, height});
    const Lamp disk(std::make_unique<Disk>(1.0f), 3, place);
    ExpectIrradiance(disk.light(), {0.3f, 0.2f, 0}, kUp, 3 * kPi);
    const Lamp rectangle(std::make_unique<Rectangle>(2.0f, 1.0f), 3, place);
    ExpectIrradiance(rectangle.light(), {0.3f, 0.2f, 0}, kUp, 3 * kPi);
  }
}

// CF8: a point under one corner of an a x b rectangle at height h, A = a/h, B = b/h:
// E = (L / 2) [A / sqrt(1 + A^2) atan(B / sqrt(1 + A^2)) + B / sqrt(1 + B^2) atan(A / sqrt(1 +
// B^2))].
TEST(RectangleLight, OverAParallelPlaneGivesTheClosedForm) {
  const Lamp square(std::make_unique<Rectangle>(2.0f, 2.0f), 1, Mat4::Translate({0, 0, 1}));
  ExpectIrradiance(square.light(), {0, 0, 0}, kUp, 1.740840);
  const Lamp corner(std::make_unique<Rectangle>(1.0f, 2.0f), 4, Mat4::Translate({0.5, 1, 1.5}));
  ExpectIrradiance(corner.light(), {0, 0, 0}, kUp, 1.537617);
}

// A transform that slants it changes how it is sampled, not what it gives: two parallelograms of
// the same outline, one made of triangles.
TEST(RectangleLight, SlantedByItsNodeGivesWhatItsTrianglesGive) {
  const Mat4 place = Mat4::Translate({0.2, 0.1, 1}) * Mat4::Scale({2, 1, 1}) * Mat4::Rotate(2, 40);
  const Lamp lamp(std::make_unique<Rectangle>(2.0f, 1.0f), 1, place);
  const Lamp lower(
      std::make_unique<Triangle>(Vec3{-1, -0.5f, 0}, Vec3{1, -0.5f, 0}, Vec3{1, 0.5f, 0}), 1,
      place);
  const Lamp upper(
      std::make_unique<Triangle>(Vec3{-1, -0.5f, 0}, Vec3{1, 0.5f, 0}, Vec3{-1, 0.5f, 0}), 1,
      place);
  const auto a = IrradianceOf(lower.light(), {0, 0, 0}, kUp);
  const auto b = IrradianceOf(upper.light(), {0, 0, 0}, kUp);
  const auto whole = IrradianceOf(lamp.light(), {0, 0, 0}, kUp);
  const double error = std::sqrt(a.error * a.error + b.error * b.error + whole.error * whole.error);
  EXPECT_LE(std::abs(a.mean + b.mean - whole.mean), test::kLargestDeviate * error + 1e-5);
  EXPECT_LE(error, 1e-3 * whole.mean);
}

// CF9: Lambert: E = (L / 2) |sum of angle_i n . g_i| over the edges.
TEST(TriangleLight, GivesLambertsSumOverItsEdges) {
  const Lamp lamp(std::make_unique<Triangle>(Vec3{1, 0, 1}, Vec3{-0.5f, 1, 2}, Vec3{0, -1, 1.5f}),
                  1);
  ExpectIrradiance(lamp.light(), {0, 0, 0}, kUp, 0.491770);
}

// CF9: a triangle that reaches below the horizon counts with what is above: cut at z = 0, it is a
// quadrangle, whose sum over edges is that of two triangles.
TEST(TriangleLight, BelowTheHorizonIsCut) {
  const Lamp whole(std::make_unique<Triangle>(Vec3{1, -1, -1}, Vec3{1, 1, -1}, Vec3{1, 0, 1}), 2);
  const Lamp above(std::make_unique<Triangle>(Vec3{1, -0.5f, 0}, Vec3{1, 0.5f, 0}, Vec3{1, 0, 1}),
                   2);
  const auto cut = IrradianceOf(whole.light(), {0, 0, 0}, kUp, 65536);
  const auto expected = IrradianceOf(above.light(), {0, 0, 0}, kUp, 65536);
  const double error = std::sqrt(cut.error * cut.error + expected.error * expected.error);
  EXPECT_LE(std::abs(cut.mean - expected.mean), test::kLargestDeviate * error + 1e-6);
  EXPECT_LE(error, 1e-3 * expected.mean);
}

/// A square of two triangles and, far above it where nothing sees it edge-on, the same again.
std::shared_ptr<const MeshSpec> TwoSquares() {
  auto spec = std::make_shared<MeshSpec>();
  for (const float z : {1.0f, 3.0f}) {
    const auto first = static_cast<uint32_t>(spec->positions.size());
    for (const Vec3 p : {Vec3{-1, -1, z}, Vec3{1, -1, z}, Vec3{1, 1, z}, Vec3{-1, 1, z}}) {
      spec->positions.push_back(p);
    }
    spec->triangles.push_back({first, first + 2, first + 1});
    spec->triangles.push_back({first, first + 3, first + 2});
  }
  return spec;
}

// Samples of hidden parts are the shadow rays' business: without those the two add up.
TEST(MeshLight, GivesTheSumOfItsTriangles) {
  const Lamp lamp(std::make_unique<Mesh>(TwoSquares()), 1);
  const Lamp far(std::make_unique<Rectangle>(2.0f, 2.0f), 1, Mat4::Translate({0, 0, 3}));
  const double expected = 1.740840 + IrradianceOf(far.light(), {0, 0, 0}, kUp).mean;
  const auto e = IrradianceOf(lamp.light(), {0, 0, 0}, kUp, 65536);
  EXPECT_LE(std::abs(e.mean - expected), test::kLargestDeviate * e.error + 1e-5 * expected);
  EXPECT_LE(e.error, 1e-3 * expected);
}

// Its triangles look down, as their corners say.
TEST(MeshLight, OfOneSideShinesToWhereItsCornersAreCounterClockwise) {
  const Lamp below(std::make_unique<Mesh>(TwoSquares()), 1, Mat4::Identity(), false);
  EXPECT_GT(IrradianceOf(below.light(), {0, 0, 0}, kUp, 64).mean, 1);
  EXPECT_EQ(IrradianceOf(below.light(), {0, 0, 9}, -kUp, 64).mean, 0);
  const Lamp mirrored(std::make_unique<Mesh>(TwoSquares()), 1, Mat4::Scale({-1, 1, 1}), false);
  EXPECT_GT(IrradianceOf(mirrored.light(), {0, 0, 0}, kUp, 64).mean, 1);
}

TEST(OneSidedLight, GivesTheSameOnItsSideAndNothingOnTheOther) {
  const Lamp lamp(std::make_unique<Rectangle>(2.0f, 2.0f), 1, Mat4::Identity(), false);
  ExpectIrradiance(lamp.light(), {0, 0, 1}, -kUp, 1.740840);
  EXPECT_EQ(IrradianceOf(lamp.light(), {0, 0, -1}, kUp, 64).mean, 0);
}

}  // namespace
}  // namespace candela
