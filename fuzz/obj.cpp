// Any bytes as an OBJ text: reading ends, and a mesh without errors can be used without checks.
#include <algorithm>
#include <memory>
#include <string>
#include <string_view>

#include "base/check.h"
#include "loaders/obj/obj_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  using namespace candela;
  Diagnostics diagnostics;
  const MeshSpec mesh =
      ParseObj(std::make_shared<const std::string>("fuzz.obj"),
               std::string_view(reinterpret_cast<const char*>(data), size), &diagnostics);
  for (const std::string& line : diagnostics.Lines()) CHECK(line.size() < 500);
  if (diagnostics.HasErrors()) return 0;

  const auto are_below = [](const MeshSpec::Corners& corners, size_t count, bool may_be_none) {
    return std::all_of(corners.begin(), corners.end(), [&](uint32_t corner) {
      return corner < count || (may_be_none && corner == MeshSpec::kNoNormal);
    });
  };
  for (const Vec3 position : mesh.positions) CHECK(IsFinite(position));
  for (const Vec3 normal : mesh.normals) CHECK(IsFinite(normal));
  for (const auto& corners : mesh.triangles)
    CHECK(are_below(corners, mesh.positions.size(), false));
  for (const auto& corners : mesh.normal_corners) {
    CHECK(are_below(corners, mesh.normals.size(), true));
  }
  CHECK(mesh.normal_corners.empty() || mesh.normal_corners.size() == mesh.triangles.size());
  return 0;
}
