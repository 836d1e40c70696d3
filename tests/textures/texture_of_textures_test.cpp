// Textures made of others, and textures that fill the space of an object, as scenes have them.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>

#include "materials/material.h"
#include "tests/support/compile_text.h"

namespace candela {
namespace {

using testing_support::CompileText;

/// A scene with materials as bright as the last texture of `textures`, which is called t.
std::unique_ptr<const Scene> SceneOf(const std::string& textures, const std::string& nodes = "") {
  return CompileText(fmt::format("{}Textures {{ {} }}\n"
                                 "Materials {{ Material {{ diffuse texture t }} }}\n"
                                 "Scene {{ {} }}",
                                 testing_support::kCamera, textures, nodes),
                     "assets/assignment4");
}

Rgb Lookup(const Scene& scene, const SurfacePoint& point) {
  return scene.materials()[0]->Phong(point).diffuse;
}

/// The colour where a ray towards -z from (x, y, 50) ends.
Rgb SeenAt(const Scene& scene, float x, float y) {
  const Ray ray({x, y, 50}, {0, 0, -1});
  HitRecord hit;
  EXPECT_TRUE(scene.Intersect(ray, &hit)) << x << " " << y;
  if (!hit.IsHit()) return {};
  // Both kinds of points know the same.
  const Rgb color = scene.material(hit).Phong(scene.SurfaceAt(ray, hit)).diffuse;
  const Rgb whitted = scene.material(hit).Phong(scene.ShadingAt(ray, hit)).diffuse;
  EXPECT_NEAR(Length(color - whitted), 0, 1e-5f);
  return color;
}

constexpr const char* kUv = "Texture { name uv type uv } ";

TEST(TriplanarTexture, IsNotMirroredOnAnySide) {
  const auto scene =
      SceneOf(std::string(kUv) + "Texture { name t type triplanar input texture uv }");
  SurfacePoint point;
  point.p = {0.1f, 0.2f, 0.3f};
  const struct {
    Vec3 n;
    Rgb seen;
  } sides[] = {{{1, 0, 0}, {0.7f, 0.2f, 0}}, {{-1, 0, 0}, {0.3f, 0.2f, 0}},
               {{0, 1, 0}, {0.1f, 0.7f, 0}}, {{0, -1, 0}, {0.1f, 0.3f, 0}},
               {{0, 0, 1}, {0.1f, 0.2f, 0}}, {{0, 0, -1}, {0.9f, 0.2f, 0}}};
  for (const auto& [n, seen] : sides) {
    point.n_shading = point.n_geometric = n;
    EXPECT_NEAR(Length(Lookup(*scene, point) - seen), 0, 1e-6f) << n.x << n.y << n.z;
  }
}

TEST(TriplanarTexture, BlendsByTheNormal) {
  const auto scene =
      SceneOf(std::string(kUv) + "Texture { name t type triplanar input texture uv sharpness 2 }");
  SurfacePoint point;
  point.p = {0.1f, 0.2f, 0.3f};
  point.n_shading = {0.6f, 0, 0.8f};
  const Rgb seen = Rgb{0.7f, 0.2f, 0} * 0.36f + Rgb{0.1f, 0.2f, 0} * 0.64f;
  EXPECT_NEAR(Length(Lookup(*scene, point) - seen), 0, 1e-6f);
}

TEST(RampTexture, OverAnotherTexture) {
  const auto scene = SceneOf(
      "Texture { name half type constant color 0.25 0.5 0.75 }"
      "Texture { name t type ramp input texture half stops 0 1 0 0 1 0 0 1 }");
  EXPECT_EQ(Lookup(*scene, {}), (Rgb{0.5f, 0, 0.5f}));
  EXPECT_FALSE(scene->materials()[0]->NeedsTextureCoordinates());
}

TEST(MixTexture, TakesItsAmountFromATexture) {
  const auto scene = SceneOf(std::string(kUv) +
                             "Texture { name t type mix first 0 0 0 second 1 1 1 "
                             "amount texture uv }");
  SurfacePoint point;
  point.uv = {0.3f, 0.6f};
  EXPECT_NEAR(Lookup(*scene, point).x, 0.3f, 1e-6f);
}

constexpr const char* kPattern = "Texture { name t type noise octaves 3 scale 3 3 3 } ";

std::string NodeOf(const std::string& transform, const std::string& object) {
  return fmt::format(
      "Node {{ Transform {{ {} }} Component<Material> {{ index 0 }}"
      " Component<Object> {{ {} }} }} ",
      transform, object);
}

// The pattern is carved out of the space of the node, wherever that lies: for shapes, for meshes
// that are moved into the world, and for those that many nodes share.
TEST(SolidTexture, GoesWhereItsObjectGoes) {
  const std::string sphere = "type sphere radius 1", cube = "type mesh obj_file models/cube.obj",
                    rabbit = "type mesh obj_file models/bunny_200.obj";
  for (const std::string& object : {sphere, cube, rabbit}) {
    const auto still = SceneOf(kPattern, NodeOf("", object));
    const auto moved = SceneOf(kPattern, NodeOf("translate 7 3 1 scale 2 2 2", object));
    const auto turned = SceneOf(kPattern, NodeOf("z_rotate 90", object));
    const auto copies = SceneOf(kPattern, NodeOf("translate 7 3 1 scale 2 2 2", object) +
                                              NodeOf("translate 700 0 0", object));
    for (const Vec2 at : {Vec2{0.02f, 0.1f}, Vec2{-0.03f, 0.07f}, Vec2{0.01f, 0.12f}}) {
      const Rgb seen = SeenAt(*still, at.x, at.y);
      EXPECT_GT(seen.x, 0);
      const auto is_seen = [&](const Scene& scene, float x, float y) {
        EXPECT_NEAR(SeenAt(scene, x, y).x, seen.x, 1e-4f) << object;
      };
      is_seen(*moved, 7 + 2 * at.x, 3 + 2 * at.y);
      is_seen(*copies, 7 + 2 * at.x, 3 + 2 * at.y);
      is_seen(*turned, -at.y, at.x);
    }
  }
}

TEST(SolidTexture, OfTheWorldStaysWhereItIs) {
  const std::string pattern = "Texture { name t type noise space world scale 3 3 3 } ";
  const auto small = SceneOf(pattern, NodeOf("", "type rectangle width 1 height 1"));
  const auto large = SceneOf(pattern, NodeOf("scale 2 2 2", "type rectangle width 1 height 1"));
  EXPECT_NEAR(SeenAt(*small, 0.3f, 0.2f).x, SeenAt(*large, 0.3f, 0.2f).x, 1e-5f);
}

}  // namespace
}  // namespace candela
