#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "tests/kernel/degenerate_scenes.h"
#include "tests/support/effort.h"

namespace candela::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kLargest = std::numeric_limits<float>::max();
constexpr float kSmallest = std::numeric_limits<float>::min();
constexpr float kTiniest = std::numeric_limits<float>::denorm_min();
constexpr uint32_t kMany = testing_support::kIsSanitized ? 2'000 : 1'000'000;

using Corners = std::array<Vec3, 3>;

/// Triangles one by one, without a common vertex.
TestMesh Loose(uint32_t count, const std::function<Corners(uint32_t)>& triangle) {
  TestMesh mesh;
  for (uint32_t i = 0; i < count; ++i) {
    for (const Vec3 corner : triangle(i)) mesh.positions.push_back(corner);
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

GroupDescription LooseGroup(uint32_t count, const std::function<Corners(uint32_t)>& triangle) {
  return OfMesh(Loose(count, triangle));
}

UniformNumbers Random() {
  return UniformNumbers(11);
}

/// A random soup whose coordinates are mapped one by one.
GroupDescription SoupWith(const std::function<float(float)>& coordinate, uint32_t count = 500) {
  UniformNumbers random = Random();
  TestMesh soup = Soup(count, 0.05f, 0.5f, &random);
  for (Vec3& p : soup.positions) p = {coordinate(p.x), coordinate(p.y), coordinate(p.z)};
  return OfMesh(std::move(soup));
}

/// A random soup with every tenth corner replaced.
GroupDescription SoupWithBad(Vec3 bad) {
  UniformNumbers random = Random();
  TestMesh soup = Soup(500, 0.05f, 0.5f, &random);
  for (size_t i = 0; i < soup.positions.size(); i += 10) soup.positions[i] = bad;
  return OfMesh(std::move(soup));
}

}  // namespace

std::vector<DegenerateScene> DegenerateMeshes() {
  return {
      // Little or nothing.
      {"NoItems", [] { return GroupDescription(); }},
      {"FreeIndicesOnly",
       [] {
         GroupDescription group;
         group.items.resize(100);
         return group;
       }},
      {"AMeshWithoutTriangles",
       [] {
         return OfMesh({{{0, 0, 0}, {1, 0, 0}}, {}});
       }},
      {"OneTriangle",
       [] { return LooseGroup(1, [](uint32_t) {
              return Corners{{{}, {1, 0, 0}, {0, 1, 0}}};
            }); }},
      {"AThousandMeshesOfOneTriangle",
       [] {
         GroupDescription group;
         UniformNumbers random = Random();
         for (int i = 0; i < 1000; ++i) group.Add(Soup(1, 0.1f, 0.5f, &random));
         return group;
       }},

      // All the same.
      {"AMillionCoincidentTriangles",
       [] {
         TestMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
         mesh.triangles.assign(kMany, {0, 1, 2});
         return OfMesh(std::move(mesh));
       }},
      {"AMillionCoincidentLooseTriangles",
       [] {
         return LooseGroup(kMany / 10, [](uint32_t) {
           return Corners{{{}, {1, 0, 0}, {0, 1, 0}}};
         });
       }},
      {"CoincidentMovingTriangles",
       [] {
         TestMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {}, 2};
         mesh.triangles.assign(5000, {0, 1, 2});
         return OfMesh(std::move(mesh));
       }},
      {"TheSameMeshAHundredTimes",
       [] {
         GroupDescription group;
         for (int i = 0; i < 100; ++i) group.Add(Globe(5, 6));
         return group;
       }},
      {"IdenticalCentroids",
       [] {
         return LooseGroup(3000, [](uint32_t i) {
           const float s = 1 + static_cast<float>(i) * 0.001f;
           return Corners{{{-s, -s, 0}, {s, -s, 0}, {0, 2 * s, 0}}};
         });
       }},
      {"IdenticalCentroidsTurned",
       [] {
         UniformNumbers random = Random();
         return LooseGroup(3000, [&](uint32_t) {
           const Vec3 a = RandomPoint(&random), b = RandomPoint(&random);
           return Corners{{a, b, -(a + b)}};
         });
       }},
      {"DuplicatedVertices",
       [] {
         TestMesh mesh = Globe(20, 20);
         const size_t count = mesh.positions.size();
         mesh.positions.insert(mesh.positions.end(), mesh.positions.begin(), mesh.positions.end());
         for (size_t i = 0; i < mesh.triangles.size(); i += 2) {
           for (uint32_t& vertex : mesh.triangles[i]) vertex += static_cast<uint32_t>(count);
         }
         return OfMesh(std::move(mesh));
       }},
      {"EachTriangleTwiceWithEitherWinding",
       [] {
         TestMesh mesh = Globe(20, 20);
         const auto triangles = mesh.triangles;
         for (const auto& [a, b, c] : triangles) mesh.triangles.push_back({c, b, a});
         return OfMesh(std::move(mesh));
       }},

      // Without area.
      {"APointAsATriangle",
       [] {
         return LooseGroup(1, [](uint32_t) { return Corners{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}; });
       }},
      {"PointsOnly",
       [] {
         UniformNumbers random = Random();
         return LooseGroup(1000, [&](uint32_t) {
           const Vec3 p = RandomPoint(&random);
           return Corners{p, p, p};
         });
       }},
      {"TwoCornersTheSame",
       [] {
         UniformNumbers random = Random();
         return LooseGroup(1000, [&](uint32_t) {
           const Vec3 p = RandomPoint(&random);
           return Corners{p, p, RandomPoint(&random)};
         });
       }},
      {"CollinearAlongAnAxis",
       [] {
         return LooseGroup(1000, [](uint32_t i) {
           const auto x = static_cast<float>(i);
           return Corners{{{x, 0, 0}, {x + 1, 0, 0}, {x + 3, 0, 0}}};
         });
       }},
      {"CollinearAcrossAxes",
       [] {
         UniformNumbers random = Random();
         return LooseGroup(1000, [&](uint32_t) {
           const Vec3 p = RandomPoint(&random), d = RandomPoint(&random);
           return Corners{p, p + d, p + d * 3};
         });
       }},
      {"OneInTenHasAnArea",
       [] {
         UniformNumbers random = Random();
         return LooseGroup(1000, [&](uint32_t i) {
           const Vec3 p = RandomPoint(&random);
           if (i % 10 != 0) return Corners{p, p, p};
           return Corners{p, p + RandomPoint(&random), p + RandomPoint(&random)};
         });
       }},
      {"ACollapsedMesh",
       [] {
         return OfMesh(Moved(Globe(30, 30), 0, {1, 2, 3}));
       }},
      {"ASphereFlattenedToADisc",
       [] {
         return OfMesh(Globe(30, 30, {1, 0, 1}));
       }},
      {"ASphereFlattenedToALine",
       [] {
         return OfMesh(Globe(30, 30, {1, 0, 0}));
       }},

      // In planes, and thin.
      {"AllInOnePlane",
       [] {
         UniformNumbers random = Random();
         TestMesh soup = Soup(1000, 0.05f, 0.5f, &random);
         for (Vec3& p : soup.positions) p.z = 0;
         return OfMesh(std::move(soup));
       }},
      {"AllInOneSlantedPlane",
       [] {
         UniformNumbers random = Random();
         TestMesh soup = Soup(1000, 0.05f, 0.5f, &random);
         for (Vec3& p : soup.positions) p.z = p.x * 0.3f + p.y * 0.7f;
         return OfMesh(std::move(soup));
       },
       false, true},
      {"AFlatGrid", [] { return OfMesh(CurvedGrid(64, 0)); }},
      {"AFlatGridInAFarPlane",
       [] {
         return OfMesh(Moved(CurvedGrid(40, 0), 1, {0, 1e6f, 0}));
       }},
      {"ALatticeOfBoxes",
       [] {
         std::vector<TestMesh> boxes;
         for (int i = 0; i < 512; ++i) {
           const Vec3 low{static_cast<float>(i % 8), static_cast<float>(i / 8 % 8),
                          static_cast<float>(i / 64)};
           boxes.push_back(BoxMesh(low, low + Vec3{1, 1, 1}));
         }
         return OfMesh(Join(boxes));
       }},
      {"NeedlesAMillionToOne",
       [] {
         UniformNumbers random = Random();
         return OfMesh(Slivers(1000, 1e-6f, &random));
       }},
      {"ParallelNeedles",
       [] {
         return LooseGroup(1000, [](uint32_t i) {
           const float y = static_cast<float>(i) * 1e-3f;
           return Corners{{{-1000, y, 0}, {1000, y, 0}, {1000, y + 1e-3f, 0}}};
         });
       }},
      {"SlantedNeedlesThatCross",
       [] {
         return LooseGroup(1000, [](uint32_t i) {
           const float y = static_cast<float>(i) * 1e-3f;
           return Corners{{{-1, y, -1}, {1, -y, 1}, {1, -y + 1e-4f, 1}}};
         });
       }},
      {"AFanOfNeedles",
       [] {
         TestMesh fan = Globe(1, 2000);
         return OfMesh(std::move(fan));
       }},
      {"OneHugeTriangleOverManyTinyOnes",
       [] {
         UniformNumbers random = Random();
         return OfMesh(
             Join({Loose(1,
                         [](uint32_t) {
                           return Corners{{{-1e6f, 0, -1e6f}, {1e6f, 0, -1e6f}, {0, 0, 1e6f}}};
                         }),
                   Soup(1000, 1e-4f, 1e-3f, &random)}));
       }},

      // Very large, very small.
      {"Coordinates1e30", [] { return SoupWith([](float x) { return x * 1e30f; }); }},
      {"Coordinates1e36", [] { return SoupWith([](float x) { return x * 1e36f; }); }},
      {"CoordinatesNearTheLargest", [] { return SoupWith([](float x) { return x * 1e38f; }); },
       true},
      {"TheLargestFloats",
       [] {
         return LooseGroup(4, [](uint32_t i) {
           const float s = i % 2 == 0 ? kLargest : -kLargest;
           return Corners{{{s, -kLargest, i < 2 ? s : 1}, {s, kLargest, 0}, {-s, 0, kLargest}}};
         });
       },
       true},
      {"Coordinates1e-30", [] { return SoupWith([](float x) { return x * 1e-30f; }); }},
      {"SmallestNormalFloats", [] { return SoupWith([](float x) { return x * kSmallest; }); }},
      {"Denormals", [] { return SoupWith([](float x) { return x * 1e-42f; }); }},
      {"TheTiniestFloats",
       [] {
         return LooseGroup(3, [](uint32_t i) {
           const float z = static_cast<float>(i) * kTiniest;
           return Corners{{{0, 0, z}, {kTiniest, 0, z}, {0, kTiniest, z}}};
         });
       }},
      {"1e-30And1e30",
       [] {
         UniformNumbers random = Random();
         const TestMesh soup = Soup(300, 0.05f, 0.5f, &random);
         return OfMesh(Join({Moved(soup, 1e-30f, {}), Moved(soup, 1e30f, {})}));
       }},
      {"1e-30And1e30InOneTriangle",
       [] { return SoupWith([](float x) { return x > 0 ? x * 1e30f : x * 1e-30f; }); }},
      {"MinusZeros",
       [] {
         TestMesh grid = CurvedGrid(20, 0);
         for (size_t i = 0; i < grid.positions.size(); i += 2) grid.positions[i].y = -0.0f;
         return OfMesh(std::move(grid));
       }},

      // Not finite.
      {"CornersThatAreNotNumbers",
       [] {
         return SoupWithBad({kNaN, 0, 0});
       }},
      {"CornersThatAreInfinite",
       [] {
         return SoupWithBad({0, kInfinity, 0});
       }},
      {"CornersInfiniteBothWays",
       [] {
         UniformNumbers random = Random();
         TestMesh soup = Soup(300, 0.05f, 0.5f, &random);
         for (size_t i = 0; i < soup.positions.size(); i += 9) {
           soup.positions[i].x = kInfinity;
           soup.positions[i + 1].x = -kInfinity;
         }
         return OfMesh(std::move(soup));
       }},
      {"NothingIsANumber",
       [] {
         return LooseGroup(100, [](uint32_t) {
           return Corners{{{kNaN, kNaN, kNaN}, {}, {1, 0, 0}}};
         });
       }},
      {"NotFiniteInTheMiddleOfAMotion",
       [] {
         UniformNumbers random = Random();
         TestMesh moving = InMotion(Soup(200, 0.05f, 0.5f, &random), 3, 0.3f, &random);
         for (size_t i = 600; i < 1200; i += 21)
           moving.positions[i].y = i % 2 == 0 ? kNaN : kInfinity;
         return OfMesh(std::move(moving));
       }},

      // Far apart.
      {"ExponentiallySpaced",
       [] {
         return LooseGroup(250, [](uint32_t i) {
           const float x = std::ldexp(1.0f, static_cast<int>(i) - 125);
           return Corners{{{x, 0, 0}, {x * 1.25f, 0, 0}, {x, x, x}}};
         });
       }},
      {"ExponentiallySpacedManyTimes",
       [] {
         return LooseGroup(5000, [](uint32_t i) {
           const float x = std::ldexp(1.0f, static_cast<int>(i % 250) - 125);
           return Corners{{{x, 0, 0}, {x * 1.25f, 0, 0}, {x, x, i % 2 == 0 ? x : -x}}};
         });
       }},
      {"NestedShells",
       [] {
         std::vector<TestMesh> shells;
         for (int i = -40; i < 40; ++i) {
           shells.push_back(Moved(Globe(3, 5), std::ldexp(1.0f, i), {}));
         }
         return OfMesh(Join(shells));
       }},
      {"TwoClusters1e10Apart",
       [] {
         UniformNumbers random = Random();
         const TestMesh soup = Soup(300, 0.05f, 0.5f, &random);
         return OfMesh(Join({soup, Moved(soup, 1e4f, {1e10f, 0, 0})}));
       }},
      {"ALongRowOfTriangles",
       [] {
         return LooseGroup(2000, [](uint32_t i) {
           const auto x = static_cast<float>(i);
           return Corners{{{x, 0, 0}, {x + 0.5f, 0, 0}, {x, 1, 0.1f}}};
         });
       }},
  };
}

}  // namespace candela::test
