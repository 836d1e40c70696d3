#include <cmath>
#include <vector>

#include "geometry/triangle.h"
#include "sampling/alias_table.h"
#include "sampling/warp.h"
#include "shapes/mesh.h"
#include "shapes/surface_sampler.h"

namespace candela {
namespace {

/// By area: a triangle from an alias table, then a point of it.
class MeshSampler final : public SurfaceSampler {
 public:
  /// The spans live longer than the sampler. `is_mirrored`: in the world, normals point to where
  /// corners are seen clockwise.
  MeshSampler(std::span<const Vec3> positions, std::span<const MeshSpec::Corners> triangles,
              std::vector<double> areas, double area, const Transform& world_from_object,
              bool is_mirrored)
      : positions_(positions),
        triangles_(triangles),
        world_from_object_(world_from_object),
        is_mirrored_(is_mirrored),
        area_(area),
        table_(areas) {}

  SurfaceSample Sample(Vec3 from, Vec2 u) const override {
    const Drawn drawn = Draw(u);
    return SampleByArea(from, drawn.p, drawn.n, area_);
  }

  float Pdf(Vec3 from, Vec3 p, Vec3 n) const override { return PdfByArea(from, p, n, area_); }

  AreaSample SampleArea(Vec2 u) const override {
    const Drawn drawn = Draw(u);
    return SampleOfArea(drawn.p, drawn.n, drawn.size, PdfArea(drawn.n));
  }

  double Area() const override { return area_; }
  uint64_t MemoryBytes() const override { return sizeof *this + table_.MemoryBytes(); }

 private:
  /// A point of a triangle of the given size.
  struct Drawn {
    Vec3 p, n;
    float size;
  };
  Drawn Draw(Vec2 u) const {
    // The first number has too few digits to choose among many triangles; the second lends its own.
    // What it chooses by them is too little to be seen beside what it does on the triangle.
    const auto [index, rest] = table_.Draw(double{u.x} + double{u.y} * 0x1p-24);
    const auto& corners = triangles_[index];
    const Vec3 a = world_from_object_.Point(positions_[corners[0]]);
    const Vec3 b = world_from_object_.Point(positions_[corners[1]]);
    const Vec3 c = world_from_object_.Point(positions_[corners[2]]);
    const Vec3 n = TriangleNormal(a, b, c);
    const Vec2 weights = SampleTriangle({static_cast<float>(rest), u.y});
    return {TrianglePoint(a, b, c, weights.x, weights.y), is_mirrored_ ? -n : n,
            Length(b - a) + Length(c - a)};
  }

  std::span<const Vec3> positions_;
  std::span<const MeshSpec::Corners> triangles_;
  Transform world_from_object_;
  bool is_mirrored_;
  double area_;
  AliasTable table_;
};

bool IsMirroring(const Transform& transform) {
  return Dot(transform.Vector({1, 0, 0}),
             Cross(transform.Vector({0, 1, 0}), transform.Vector({0, 0, 1}))) < 0;
}

}  // namespace

std::unique_ptr<const SurfaceSampler> Mesh::MakeSampler(const Transform& world_from_object,
                                                        const Transform&) const {
  std::vector<double> areas;
  areas.reserve(spec_->triangles.size());
  double sum = 0;
  for (const auto& [a, b, c] : spec_->triangles) {
    areas.push_back(Length(TriangleCross(world_from_object.Point(positions_[a]),
                                         world_from_object.Point(positions_[b]),
                                         world_from_object.Point(positions_[c]))) /
                    2);
    sum += areas.back();
  }
  if (!(sum > 0 && std::isfinite(sum))) return nullptr;
  return std::make_unique<MeshSampler>(positions_, spec_->triangles, std::move(areas), sum,
                                       world_from_object,
                                       is_mirrored_ != IsMirroring(world_from_object));
}

}  // namespace candela
