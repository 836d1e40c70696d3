#include "tests/kernel/degenerate_scenes.h"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "tests/kernel/sphere_set.h"

namespace candela::test {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kLargest = std::numeric_limits<float>::max();

GroupDescription OfSet(std::vector<SphereSet::Sphere> spheres) {
  GroupDescription group;
  group.items.push_back({std::make_shared<SphereSet>(std::move(spheres)), kAnyRay, nullptr});
  return group;
}

Mat4 Scaled(double x, double y, double z) {
  return Mat4::Scale({x, y, z});
}

/// Spheres whose boxes say something else than what is there.
class SetWithBoxes : public SphereSet {
 public:
  SetWithBoxes(std::vector<Sphere> spheres, std::vector<Bounds3> boxes)
      : SphereSet(std::move(spheres)), boxes_(std::move(boxes)) {}
  Bounds3 PrimitiveBounds(uint32_t primitive, uint32_t) const override { return boxes_[primitive]; }

 private:
  std::vector<Bounds3> boxes_;
};

GroupDescription UnboundedPrimitives(size_t count) {
  GroupDescription group;
  for (size_t i = 0; i < count; ++i) {
    group.items.push_back({std::make_shared<GroundSet>(-static_cast<float>(i)), kAnyRay, nullptr});
  }
  return group;
}

}  // namespace

GroupDescription InstancesOf(GroupDescription inner, const std::vector<std::vector<Mat4>>& steps) {
  const auto shared = std::make_shared<GroupDescription>(std::move(inner));
  GroupDescription group;
  for (const std::vector<Mat4>& matrices : steps) {
    group.items.push_back({GroupDescription::Instance{shared, matrices}, kAnyRay, nullptr});
  }
  return group;
}

std::vector<DegenerateScene> DegenerateGroups() {
  return {
      // Little or nothing.
      {"ASetWithoutPrimitives", [] { return OfSet({}); }},
      {"OneSphere",
       [] {
         return OfSet({{{{0, 0, 0}}, 1}});
       }},
      {"OneInstance", [] { return InstancesOf(OfMesh(Globe(5, 5)), {{Mat4::Identity()}}); }},
      {"AnEmptyGroupInInstances",
       [] {
         return InstancesOf(
             GroupDescription(),
             {{Mat4::Identity()}, {Scaled(2, 2, 2)}, {Scaled(1, 1, 1), Scaled(2, 2, 2)}});
       }},
      {"AGroupOfEmptyGroups",
       [] {
         return InstancesOf(InstancesOf(GroupDescription(), {{Mat4::Identity()}}),
                            {{Mat4::Identity()}, {Scaled(2, 2, 2)}});
       }},
      {"CoincidentSpheres",
       [] {
         return OfSet(std::vector<SphereSet::Sphere>(5000, {{{0, 0, 0}}, 1}));
       }},
      {"CoincidentInstances",
       [] {
         return InstancesOf(OfMesh(Globe(4, 4)),
                            std::vector<std::vector<Mat4>>(200, {Mat4::Identity()}));
       }},
      {"SpheresOfRadiusZero",
       [] {
         return OfSet(std::vector<SphereSet::Sphere>(100, {{{0.5f, 0, 0}}, 0}));
       }},

      // Instances.
      {"InstancesOfAnySize",
       [] {
         return InstancesOf(OfMesh(Globe(6, 6)), {{Scaled(1e-10, 1e-10, 1e-10)},
                                                  {Scaled(1e10, 1e10, 1e10)},
                                                  {Scaled(1, 1, 1)},
                                                  {Scaled(1e5, 1e-5, 1)},
                                                  {Scaled(-1, 1, 1)}});
       }},
      {"InstancesAtTheEndsOfTheFloats",
       [] {
         return InstancesOf(
             OfMesh(Globe(6, 6)),
             {{Scaled(1e-30, 1e-30, 1e-30)}, {Scaled(1e30, 1e30, 1e30)}, {Scaled(1e30, 1e-30, 1)}});
       }},
      {"AnInstanceFarAway",
       [] {
         return InstancesOf(OfMesh(Globe(6, 6)),
                            {{Mat4::Translate({1e30, 0, 0})}, {Mat4::Translate({0, 1e10, 0})}});
       }},
      // The steps of a motion are invertible, the matrices in between need not be.
      {"InstancesThatVanishAndComeBackMirrored",
       [] {
         return InstancesOf(OfMesh(Globe(6, 6)), {{Scaled(1, 1, 1), Scaled(-1, -1, -1)},
                                                  {Scaled(1, 1, 1), Scaled(1, -1, 1)},
                                                  {Scaled(1, 1, 1), Scaled(2, 1, 1)}});
       }},
      {"AMotionThatIsSingularAtHalfTime",
       [] {
         return InstancesOf(OfMesh(Globe(6, 6)), {{Scaled(1, 1, 1), Scaled(-1, 1, 1)}});
       }},
      {"InstancesOfUnboundedPrimitives",
       [] {
         return InstancesOf(UnboundedPrimitives(2),
                            {{Mat4::Identity()},
                             {Mat4::Translate({0, -3, 0})},
                             {Mat4::Identity(), Mat4::Translate({0, 1, 0})}});
       }},

      // Primitives of sets.
      {"UnboundedPrimitivesOnly", [] { return UnboundedPrimitives(40); }},
      {"UnboundedPrimitivesBesideTriangles",
       [] {
         GroupDescription group = UnboundedPrimitives(3);
         group.Add(Globe(10, 10));
         return group;
       }},
      {"EmptyBoxes",
       [] {
         GroupDescription group;
         const std::vector<SphereSet::Sphere> spheres(3, {{{0, 0, 0}}, 0});
         group.items.push_back(
             {std::make_shared<SetWithBoxes>(
                  spheres, std::vector<Bounds3>{{}, {{1, 1, 1}, {0, 0, 0}}, {{}, {kNaN, 0, 0}}}),
              kAnyRay, nullptr});
         return group;
       }},
      {"BoxesAsLargeAsCanBe",
       [] {
         GroupDescription group;
         const Vec3 far{kLargest, kLargest, kLargest};
         group.items.push_back(
             {std::make_shared<SetWithBoxes>(std::vector<SphereSet::Sphere>(20, {{{0, 0, 0}}, 1}),
                                             std::vector<Bounds3>(20, Bounds3{-far, far})),
              kAnyRay, nullptr});
         return group;
       }},
      {"SpheresOfAnySize",
       [] {
         std::vector<SphereSet::Sphere> spheres;
         for (int i = -30; i <= 30; ++i) {
           const float size = static_cast<float>(std::pow(10.0, i / 2));
           spheres.push_back({{{3 * size, 0, 0}}, size});
         }
         return OfSet(std::move(spheres));
       }},
  };
}

}  // namespace candela::test
