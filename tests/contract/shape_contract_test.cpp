// What holds for every shape. Shapes stand in the world under each of a few transforms, unless said
// otherwise, since that is how they are met.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/spawn_ray.h"
#include "math/elementary.h"
#include "sampling/warp.h"
#include "tests/contract/rows.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using contract::SceneOfShape;
using test::UniformNumbers;

/// Of two nested nodes, so that shears can be had too.
struct Placement {
  const char* name;
  const char* outer;
  const char* inner;
};

constexpr Placement kPlacements[] = {
    {"as it is", "", ""},
    {"far away", "translate 1000 -300 77", ""},
    {"turned", "x_rotate 30 y_rotate -100 z_rotate 7", ""},
    {"stretched", "z_rotate 20", "scale 10 0.1 1"},
    {"sheared", "scale 3 1 1", "z_rotate 40"},
    {"mirrored", "scale -1 1 1", "translate 1 2 3 x_rotate 12"},
    {"tiny", "translate 0.001 0 0", "scale 1e-5 1e-5 1e-5"},
    {"huge", "y_rotate 45", "scale 1e7 1e7 1e7"},
    {"turned far away", "translate 1000 -300 77 x_rotate 33 y_rotate 20", "scale 1 2 1"},
};

class EveryShape : public testing::TestWithParam<ShapeEntry> {
 protected:
  /// A point of the box around the shape; of an unbounded one, of a box around the origin.
  Vec3 PointNear(const Shape& shape) {
    Bounds3 box = shape.ObjectBounds();
    if (!box.IsFinite()) box = {{-2, -2, -2}, {2, 2, 2}};
    const Vec2 xy = random_.NextPair();
    return box.min + box.Extent() * Vec3{xy.x, xy.y, random_.Next()};
  }

  /// A ray from somewhere outside (or, every fourth time, inside) towards the shape, in the world.
  Ray RayTowards(const Shape& shape) {
    const Vec3 target = PointNear(shape);
    const Vec3 side = SampleUniformSphere(random_.NextPair());
    const float distance = random_.Next() < 0.25f ? 0.1f : 4.0f;
    const Vec3 origin = target + side * distance;
    return {to_world_.Point(origin), Normalize(to_world_.Vector(target - origin))};
  }

  /// Calls `check(scene, ray, hit)` for hits of the shape in each placement.
  template <class Check>
  void ForHits(int count, Check&& check) {
    const auto plain = SceneOfShape(GetParam().example);
    for (const Placement& placement : kPlacements) {
      SCOPED_TRACE(placement.name);
      const auto scene = SceneOfShape(GetParam().example, placement.outer, placement.inner);
      ASSERT_EQ(scene->objects().size(), 1u);
      // A sphere tells where the placement leads to: a mesh may have been moved there already.
      const auto sphere = SceneOfShape("type sphere radius 1", placement.outer, placement.inner);
      to_world_ = sphere->objects()[0].world_from_object;
      to_object_ = sphere->objects()[0].object_from_world;
      int hits = 0;
      for (int tries = 0; hits < count; ++tries) {
        ASSERT_LT(tries, 100 * count) << "the shape is hardly ever hit";
        const Ray ray = RayTowards(*plain->objects()[0].shape);
        HitRecord hit;
        if (!scene->Intersect(ray, &hit)) continue;
        ++hits;
        check(*scene, ray, hit);
        if (HasFailure()) return;
      }
    }
  }

  Transform to_world_, to_object_;  ///< Of the placement in work.
  UniformNumbers random_{11};
};

INSTANTIATE_TEST_SUITE_P(Registry, EveryShape,
                         testing::ValuesIn(ShapeEntries().begin(), ShapeEntries().end()),
                         contract::RowName<ShapeEntry>);

bool AreSame(const HitRecord& a, const HitRecord& b) {
  return a.t == b.t && a.u == b.u && a.v == b.v && a.object == b.object &&
         a.primitive == b.primitive;
}

TEST_P(EveryShape, HasAPrimitiveAndTakesMemory) {
  const auto scene = SceneOfShape(GetParam().example);
  EXPECT_GE(scene->objects()[0].shape->PrimitiveCount(), 1u);
  EXPECT_GT(scene->objects()[0].shape->MemoryBytes(), 0u);
  EXPECT_EQ(scene->objects()[0].type, GetParam().name);
}

TEST_P(EveryShape, HitsLieInsideItsBounds) {
  ForHits(2000, [](const Scene& scene, const Ray& ray, const HitRecord& hit) {
    const SceneObject& object = scene.objects()[0];
    const Bounds3 box = TransformBounds(object.world_from_object, object.shape->ObjectBounds());
    const SurfacePoint point = scene.SurfaceAt(ray, hit);
    const Bounds3 wider = {box.min - point.p_error, box.max + point.p_error};
    EXPECT_TRUE(wider.Contains(point.p));
    EXPECT_LT(hit.primitive, object.shape->PrimitiveCount());
  });
}

// The point of the surface is the point of the ray, as well as its direction and distance can say:
// a ray along the surface passes many points of it nearly as close.
TEST_P(EveryShape, HitsLieOnTheRay) {
  ForHits(2000, [](const Scene& scene, const Ray& ray, const HitRecord& hit) {
    const SurfacePoint point = scene.SurfaceAt(ray, hit);
    const float scale = Length(point.p) + Length(ray.origin) + hit.t;
    const Vec3 way = ray.At(hit.t) - point.p;
    const Vec3 along = ray.direction * Dot(way, ray.direction);
    EXPECT_LE(Length(way - along), 1e-5f * scale);
    EXPECT_LE(Length(along) * std::abs(Dot(point.n_geometric, ray.direction)), 1e-5f * scale);
  });
}

TEST_P(EveryShape, TheLowerLimitCountsAndTheUpperOneDoesNot) {
  ForHits(500, [](const Scene& scene, Ray ray, const HitRecord& hit) {
    ray.t_min = hit.t;
    HitRecord again;
    EXPECT_TRUE(scene.Intersect(ray, &again));
    EXPECT_TRUE(AreSame(again, hit));
    ray.t_min = std::nextafter(hit.t, Bounds3::kInfinity);
    again = {};
    if (scene.Intersect(ray, &again)) {
      EXPECT_GT(again.t, hit.t);
    }
    ray.t_min = 0;

    HitRecord limited;
    limited.t = hit.t;
    limited.u = 0.125f, limited.v = 0.25f, limited.primitive = 77;
    const HitRecord before = limited;
    EXPECT_FALSE(scene.Intersect(ray, &limited));
    EXPECT_TRUE(AreSame(limited, before)) << "a miss changed the record";
    limited.t = std::nextafter(hit.t, Bounds3::kInfinity);
    EXPECT_TRUE(scene.Intersect(ray, &limited));
    EXPECT_TRUE(AreSame(limited, hit));
  });
}

TEST_P(EveryShape, OccludesWhereItIsHit) {
  ForHits(500, [](const Scene& scene, Ray ray, const HitRecord& hit) {
    ray.t_max = hit.t;
    EXPECT_FALSE(scene.Occluded(ray));
    ray.t_max = std::nextafter(hit.t, Bounds3::kInfinity);
    EXPECT_TRUE(scene.Occluded(ray));
  });
}

TEST_P(EveryShape, AMissLeavesTheRecordAsItWas) {
  const auto scene = SceneOfShape(GetParam().example);
  const Shape& shape = *scene->objects()[0].shape;
  int misses = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray ray(PointNear(shape) * 3, SampleUniformSphere(random_.NextPair()));
    HitRecord hit;
    hit.u = 0.125f, hit.v = 0.25f, hit.primitive = 77;
    const HitRecord before = hit;
    if (shape.Intersect(ray, &hit)) continue;
    ++misses;
    ASSERT_TRUE(AreSame(hit, before));
  }
  EXPECT_GT(misses, 100);
}

// A ray that leaves the surface, to whichever side, does not find the same spot again. Its far
// side, like that of a sphere, it may find: that is at least a part of the shape's size away, for a
// ray that is not almost tangent.
TEST_P(EveryShape, ASpawnedRayDoesNotHitTheSameSpotAgain) {
  ForHits(4000, [this](const Scene& scene, const Ray& ray, const HitRecord& hit) {
    const SurfacePoint point = scene.SurfaceAt(ray, hit);
    const Vec3 w = SampleUniformSphere(random_.NextPair());
    if (std::abs(Dot(w, point.n_geometric)) < 0.05f) return;
    const Ray spawned = SpawnRay(point, w);
    HitRecord again;
    if (!scene.Intersect(spawned, &again) || again.primitive != hit.primitive) return;
    const Vec3 way = to_object_.Vector(spawned.At(again.t) - spawned.origin);
    EXPECT_GT(Length(way), 1e-3f);
  });
}

// Two neighbouring rays that hit the same primitive span the tangent plane with the first.
TEST_P(EveryShape, ItsNormalAgreesWithFiniteDifferences) {
  int compared = 0;
  ForHits(1000, [&](const Scene& scene, const Ray& ray, const HitRecord& hit) {
    const SurfacePoint point = scene.SurfaceAt(ray, hit);
    EXPECT_NEAR(Length(point.n_geometric), 1, 1e-6);
    EXPECT_NEAR(Length(point.n_shading), 1, 1e-6);
    if (std::abs(Dot(point.n_geometric, ray.direction)) < 0.2f) return;

    // In object space, where the size of things is about 1.
    const Frame frame = Frame::FromNormal(ray.direction);
    std::optional<Vec3> sides[2];
    for (int i = 0; i < 2; ++i) {
      Ray neighbour = ray;
      const Vec3 step = i == 0 ? frame.x : frame.y;
      neighbour.origin += step * (0.003f / Length(to_object_.Vector(step)));
      HitRecord near;
      if (!scene.Intersect(neighbour, &near) || near.primitive != hit.primitive) return;
      sides[i] = to_object_.Vector(scene.SurfaceAt(neighbour, near).p - point.p);
      if (Length(*sides[i]) > 0.05f) return;  // Beyond an edge, or on the far side.
    }
    const Vec3 across = Cross(*sides[0], *sides[1]);
    // Compared in the object, to which normals go by the transpose of the way to the world.
    const Vec3 n = Normalize(to_world_.TransposedVector(point.n_geometric));
    if (Length(across) < 0.1f * Length(*sides[0]) * Length(*sides[1])) return;
    EXPECT_GT(std::abs(Dot(Normalize(across), n)), 0.99f);
    ++compared;
  });
  EXPECT_GT(compared, 2000);
}

// The scene takes the normal of such a shape into the world once, instead of for each hit.
TEST_P(EveryShape, SaysThatItIsFlatWhenAllItsNormalsAreOne) {
  const auto scene = SceneOfShape(GetParam().example);
  const Shape& shape = *scene->objects()[0].shape;
  std::optional<Vec3> first;
  bool is_flat = true;
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = RayTowards(shape);
    HitRecord hit;
    if (!shape.Intersect(ray, &hit)) continue;
    const SurfacePoint point = shape.SurfaceAt(ray, hit);
    ++hits;
    if (!first) first = point.n_geometric;
    is_flat &= point.n_geometric == *first && point.n_shading == *first;
  }
  EXPECT_GT(hits, 100);
  EXPECT_EQ(shape.FlatNormal(), is_flat ? first.value_or(Vec3()) : Vec3());
}

// Wherever it stands, mirrored or not.
TEST_P(EveryShape, OfAFlatOneTheNormalInTheWorldIsThatOfItsHits) {
  ForHits(200, [](const Scene& scene, const Ray& ray, const HitRecord& hit) {
    const SceneObject& object = scene.objects()[0];
    const Vec3 flat_normal = object.shape->FlatNormal();
    if (flat_normal == Vec3()) return;
    const Vec3 expected = object.NormalToWorld(flat_normal);
    const SurfacePoint point = scene.SurfaceAt(ray, hit);
    EXPECT_EQ(point.n_geometric, expected);
    EXPECT_EQ(point.n_shading, expected);
    EXPECT_EQ(scene.ShadingAt(ray, hit).n_shading, expected);
  });
}

// A neighbour lies where the derivatives say by its texture coordinates, in the object.
TEST_P(EveryShape, PointsMoveWithTheirTextureCoordinates) {
  int compared = 0;
  const auto plain = SceneOfShape(GetParam().example);
  const Shape& shape = *plain->objects()[0].shape;
  const auto textured_at = [&](const Ray& ray, const HitRecord& hit) {
    SurfacePoint point = shape.SurfaceAt(ray, hit);
    point.n_geometric = Normalize(point.n_geometric);
    shape.AddTextureCoordinates(hit, &point);
    return point;
  };
  for (int i = 0; i < 20000; ++i) {
    const Ray ray = RayTowards(shape);
    Ray neighbour = ray;
    neighbour.origin += SampleUniformSphere(random_.NextPair()) * 0.003f;
    HitRecord hit, near;
    if (!plain->Intersect(ray, &hit) || !plain->Intersect(neighbour, &near)) continue;
    if (hit.primitive != near.primitive) continue;
    const SurfacePoint a = textured_at(ray, hit), b = textured_at(neighbour, near);
    const Vec3 moved = b.p - a.p;
    const Vec2 d = b.uv - a.uv;
    // Beyond an edge, on the far side, across the seam of the coordinates, or close to a pole.
    if (Length(moved) > 0.02f || std::abs(d.x) > 0.01f || std::abs(d.y) > 0.01f) continue;
    EXPECT_LE(Length(a.dpdu * d.x + a.dpdv * d.y - moved), 0.1f * Length(moved) + 1e-5f);
    ++compared;
  }
  EXPECT_GT(compared, 2000);
}

// Distances do not change when the ray goes along with the object: t counts in units of the ray.
TEST_P(EveryShape, GivesTheSameAnswerUnderAnAffineTransform) {
  const auto plain = SceneOfShape(GetParam().example);
  int different = 0;
  ForHits(1000, [&](const Scene&, const Ray& ray, const HitRecord& hit) {
    const Ray local(to_object_.Point(ray.origin), to_object_.Vector(ray.direction));
    HitRecord expected;
    if (!plain->Intersect(local, &expected) || expected.primitive != hit.primitive) {
      ++different;  // At a rim or an edge rounding decides.
      return;
    }
    const Vec3 p = local.At(hit.t), q = local.At(expected.t);
    EXPECT_LE(Length(p - q), 1e-3f);
  });
  EXPECT_LT(different, 40);
}

TEST_P(EveryShape, RaysThatAreNoRaysMiss) {
  const auto scene = SceneOfShape(GetParam().example);
  const Shape& shape = *scene->objects()[0].shape;
  for (const float strange : {0.0f, NAN, INFINITY}) {
    for (int i = 0; i < 100; ++i) {
      const Vec3 origin = PointNear(shape);
      HitRecord hit;
      EXPECT_FALSE(shape.Intersect(Ray(origin, {strange, strange, strange}), &hit));
      if (strange == 0) continue;
      EXPECT_FALSE(shape.Intersect(Ray(origin * strange, {0.6f, 0.48f, 0.64f}), &hit));
    }
  }
}

}  // namespace
}  // namespace candela
