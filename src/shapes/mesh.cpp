#include "shapes/mesh.h"

#include <fmt/format.h>

#include <utility>

#include "geometry/triangle.h"
#include "shapes/deforming_mesh.h"
#include "shapes/shape_context.h"

namespace candela {
namespace {

Vec3 UnitOrZero(Vec3d v) {
  const double length = Length(v);
  return length > 0 ? ToFloat(v / length) : Vec3();
}

std::shared_ptr<const Shape> CreateDeforming(std::shared_ptr<const MeshSpec> begin,
                                             ParamReader* params, ShapeContext* context) {
  const ParamWord path = params->RequiredPath("obj_file_end");
  auto end = path.text.empty() ? nullptr : context->find_mesh(path);
  if (!begin || !end) return nullptr;
  if (const char* difference = DeformingMesh::FindDifference(*begin, *end)) {
    params->Error(path.where,
                  fmt::format("the mesh of 'obj_file' cannot become this one: {}", difference));
    return nullptr;
  }
  return std::make_shared<DeformingMesh>(std::move(begin), std::move(end));
}

}  // namespace

std::shared_ptr<const Shape> Mesh::Create(ParamReader* params, ShapeContext* context) {
  const ParamWord path = params->RequiredPath("obj_file");
  auto spec = path.text.empty() ? nullptr : context->find_mesh(path);
  if (params->Has("obj_file_end")) return CreateDeforming(std::move(spec), params, context);
  if (!spec) return nullptr;
  std::shared_ptr<const Shape>& mesh = (*context->made_of_meshes)[spec];
  if (!mesh) mesh = std::make_shared<Mesh>(std::move(spec));
  return mesh;
}

Mesh::Mesh(std::shared_ptr<const MeshSpec> spec, FaceNormals face_normals)
    : spec_(std::move(spec)),
      positions_(spec_->positions),
      normals_(spec_->normals),
      normal_corners_(spec_->normal_corners) {
  if (spec_->normal_corners.empty()) {
    ComputeVertexNormals();
  } else if (face_normals == FaceNormals::kLeaveOut) {
    LeaveOutFaceNormals();
  }
  ComputeBounds();
}

void Mesh::ComputeBounds() {
  for (const Corners& corners : spec_->triangles) {
    for (const uint32_t corner : corners) bounds_.Extend(positions_[corner]);
  }
}

void Mesh::ComputeVertexNormals() {
  // In double: the cross products of small triangles have no digits left in single precision.
  std::vector<Vec3d> sums(positions_.size());
  for (const auto& [a, b, c] : spec_->triangles) {
    const Vec3d n = TriangleCross(positions_[a], positions_[b], positions_[c]);
    for (const uint32_t corner : {a, b, c}) sums[corner] += n;
  }
  own_normals_.reserve(sums.size());
  for (const Vec3d& sum : sums) own_normals_.push_back(UnitOrZero(sum));
  normals_ = own_normals_;
  normal_corners_ = spec_->triangles;
}

/// Whether all corners have the normal of the face, up to the digits that files are written with.
bool Mesh::HasFaceNormal(size_t triangle) const {
  constexpr double kSameAngle = 2e-4;
  const auto& [i, j, k] = normal_corners_[triangle];
  constexpr uint32_t kNone = MeshSpec::kNoNormal;
  if (i == kNone || j == kNone || k == kNone) return false;
  if (normals_[i] != normals_[j] || normals_[j] != normals_[k]) return false;
  const auto& [a, b, c] = spec_->triangles[triangle];
  const Vec3d face = TriangleCross(positions_[a], positions_[b], positions_[c]);
  const Vec3d n = ToDouble(normals_[i]);
  const double cosine = Dot(face, n);  // Times both lengths, as the sine.
  return cosine > 0 && Length(Cross(face, n)) <= kSameAngle * cosine;
}

/// Files give flat faces normals as well. Where there are none, nothing is blended or lifted. It is
/// worth a list of its own only where most faces are flat.
void Mesh::LeaveOutFaceNormals() {
  const size_t count = spec_->triangles.size();
  size_t flat = 0;
  for (size_t i = 0; i < count; ++i) flat += HasFaceNormal(i) ? 1 : 0;
  if (flat <= count / 2) return;
  std::vector<Corners> left(normal_corners_.begin(), normal_corners_.end());
  for (size_t i = 0; i < count; ++i) {
    if (HasFaceNormal(i)) left[i].fill(MeshSpec::kNoNormal);
  }
  own_normal_corners_ = std::make_shared<const std::vector<Corners>>(std::move(left));
  normal_corners_ = *own_normal_corners_;
}

bool Mesh::HasNormal(size_t triangle, size_t corner) const {
  const uint32_t index = normal_corners_[triangle][corner];
  return index != MeshSpec::kNoNormal && normals_[index] != Vec3();
}

MeshTriangle Mesh::TriangleAt(uint32_t triangle) const {
  const auto& [a, b, c] = spec_->triangles[triangle];
  const Corners& normals = normal_corners_[triangle];
  const auto normal = [&](uint32_t index) {
    return index == MeshSpec::kNoNormal ? Vec3() : normals_[index];
  };
  return {{positions_[a], positions_[b], positions_[c]},
          {normal(normals[0]), normal(normals[1]), normal(normals[2])},
          is_mirrored_};
}

std::array<Vec2, 3> Mesh::UvsOf(uint32_t triangle) const {
  constexpr std::array<Vec2, 3> kOwn = {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}};
  if (spec_->uv_corners.empty()) return kOwn;
  const auto& [a, b, c] = spec_->uv_corners[triangle];
  if (a == MeshSpec::kNoUv || b == MeshSpec::kNoUv || c == MeshSpec::kNoUv) return kOwn;
  return {spec_->uvs[a], spec_->uvs[b], spec_->uvs[c]};
}

Vec3 Mesh::FaceNormal(size_t triangle) const {
  const auto& [a, b, c] = spec_->triangles[triangle];
  const Vec3 n = TriangleNormal(positions_[a], positions_[b], positions_[c]);
  return is_mirrored_ ? -n : n;
}

bool Mesh::Intersect(const Ray& ray, HitRecord* hit) const {
  const ShearedRay sheared(ray);
  bool found = false;
  for (uint32_t i = 0; i < spec_->triangles.size(); ++i) {
    const auto& [a, b, c] = spec_->triangles[i];
    if (!IntersectTriangle(sheared, ray.t_min, positions_[a], positions_[b], positions_[c], hit)) {
      continue;
    }
    hit->primitive = i;
    found = true;
  }
  return found;
}

SurfacePoint Mesh::SurfaceAt(const Ray&, const HitRecord& hit) const {
  return TriangleAt(hit.primitive).SurfaceAt(hit);
}

Vec3 Mesh::LiftOf(const HitRecord& hit, Vec3 p, float, bool is_inside) const {
  return TriangleAt(hit.primitive).LiftOf(hit, p, is_inside);
}

std::optional<TriangleInput> Mesh::Triangles() const {
  return TriangleInput{positions_, spec_->triangles};
}

uint64_t Mesh::MemoryBytes() const {
  const auto bytes = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  return sizeof *this + bytes(own_positions_) + bytes(own_normals_) +
         (own_normal_corners_ ? bytes(*own_normal_corners_) : 0) + bytes(spec_->positions) +
         bytes(spec_->normals) + bytes(spec_->triangles) + bytes(spec_->normal_corners) +
         bytes(spec_->uvs) + bytes(spec_->uv_corners);
}

void Mesh::AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const {
  TriangleAt(hit.primitive).AddTextureCoordinates(UvsOf(hit.primitive), hit, point);
}

}  // namespace candela
