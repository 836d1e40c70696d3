#include "tests/invariance/changed_scene.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "image/image_file.h"
#include "math/transform.h"
#include "tests/kernel/test_mesh.h"
#include "tests/support/temp_folder.h"

namespace candela::invariance {
namespace {

/// How the world is changed, as one transform and what goes with it.
struct Placement {
  std::string steps;  ///< As a scene has them.
  Mat4 matrix = Mat4::Identity();
  double scale = 1;
  double sky_turn = 0;
  bool is_mirrored = false;
};

/// A picture of the sky can be turned about y alone.
Placement PlacementOf(Change change, bool has_picture) {
  Placement placement;
  switch (change) {
    case Change::kRotate:
      placement.steps = "y_rotate 50";
      placement.matrix = Mat4::Rotate(1, 50);
      placement.sky_turn = 50;
      if (has_picture) break;
      placement.steps += " x_rotate 25 z_rotate -35";
      placement.matrix = placement.matrix * Mat4::Rotate(0, 25) * Mat4::Rotate(2, -35);
      break;
    case Change::kMove:
      placement.steps = "translate 7 -3 11";
      placement.matrix = Mat4::Translate({7, -3, 11});
      break;
    case Change::kScale:
      placement.steps = "scale 3.7 3.7 3.7";
      placement.matrix = Mat4::Scale({3.7, 3.7, 3.7});
      placement.scale = 3.7;
      break;
    case Change::kMirror:
      placement.steps = "scale -1 1 1";
      placement.matrix = Mat4::Scale({-1, 1, 1});
      placement.is_mirrored = true;
      break;
    default:
      break;
  }
  return placement;
}

std::string Words(Vec3d v) {
  return fmt::format("{:.9g} {:.9g} {:.9g}", v.x, v.y, v.z);
}

Vec3d Turned(const Mat4& m, Vec3d v) {
  const auto row = [&](size_t i) { return m.m[i][0] * v.x + m.m[i][1] * v.y + m.m[i][2] * v.z; };
  return {row(0), row(1), row(2)};
}

Vec3d Moved(const Mat4& m, Vec3d p) {
  return Turned(m, p) + Vec3d{m.m[0][3], m.m[1][3], m.m[2][3]};
}

/// The text with its lengths in units of the changed scene.
std::string InUnits(const std::string& text, double scale) {
  fmt::dynamic_format_arg_store<fmt::format_context> arguments;
  arguments.push_back(fmt::arg("tenth", 0.1 * scale));
  arguments.push_back(fmt::arg("near", 4.5 * scale));
  arguments.push_back(fmt::arg("per_length", 1 / scale));
  arguments.push_back(fmt::arg("per_area", 1 / (scale * scale)));
  return fmt::vformat(text, arguments);
}

std::string Node(const std::string& transform, const std::string& material,
                 const std::string& components) {
  return fmt::format("Node {{ Transform {{ {} }} Component<Material> {{ name {} }} {} }}\n",
                     transform, material, components);
}

std::string Object(const std::string& text) {
  return "Component<Object> { type " + text + " }";
}

std::string Lamp(double radiance) {
  return fmt::format(" Component<Light> {{ type area radiance {0} {0} {0} }}", radiance);
}

/// The nodes of lights by their names; `mesh` is that of the lamp that is one.
std::map<std::string, std::string> LightNodes(const Placement& placement, const std::string& mesh) {
  const Vec3d sun = Turned(placement.matrix, {-1, -1.5, -0.7});
  return {
      {"rectangle", Node("translate -2 2 0 y_rotate 60 x_rotate 30", "black",
                         Object("rectangle width 1.5 height 1") + Lamp(6))},
      {"sphere", Node("translate 2 1.6 0", "black", Object("sphere radius 0.5") + Lamp(4))},
      {"disk",
       Node("translate 0 2.5 -1 x_rotate 90", "black", Object("disk radius 0.7") + Lamp(5))},
      {"triangle",
       Node("", "black",
            Object("triangle vertex0 -2 0 -3 vertex1 2 0 -4 vertex2 0 2 -3.5") + Lamp(2))},
      {"mesh", Node("translate -1 2 0 x_rotate 30 scale 0.5 0.3 0.5", "black",
                    Object("mesh obj_file " + mesh) + Lamp(4))},
      {"point", InUnits("Node {{ Transform {{ translate 1 3 2 }} Component<Light> {{ type point "
                        "color 9 9 9 attenuation {per_area} }} }}\n",
                        placement.scale)},
      {"spot",
       InUnits("Node {{ Transform {{ translate -2 3 1 }} Component<Light> {{ type spot "
               "direction 1.5 -3 -1.5 angle 60 color 20 20 20 attenuation {per_area} }} }}\n",
               placement.scale)},
      {"sun", fmt::format("Node {{ Component<Light> {{ type directional direction {} "
                          "color 2 2 2 }} }}\n",
                          Words(sun))},
      {"soft_sun", fmt::format("Node {{ Component<Light> {{ type directional direction {} "
                               "color 2 2 2 angle 20 }} }}\n",
                               Words(sun))},
  };
}

std::string Background(const SceneRow& row, const Placement& placement) {
  const std::string sky = row.sky;
  if (sky == "even") return "Background { color 0.5 0.6 0.8 ambient_light 0 0 0 }\n";
  if (sky == "picture") {
    return fmt::format("Background {{ environment {} rotate {} }}\n",
                       placement.is_mirrored ? "sky_mirrored.pfm" : "sky.pfm",
                       (placement.is_mirrored ? -30 : 30) + placement.sky_turn);
  }
  return "";
}

std::string CameraText(const SceneRow& row, const Placement& placement) {
  return fmt::format("Camera {{ center {} direction {} up {} fov 50 {} }}\n",
                     Words(Moved(placement.matrix, {0.2, 1.2, 4.5})),
                     Words(Turned(placement.matrix, {0, -0.25, -1})),
                     Words(Turned(placement.matrix, {0, 1, 0})),
                     InUnits(row.lens, placement.scale));
}

using Corner = std::array<uint32_t, 3>;

/// A mesh whose vertices have normals and texture coordinates of their own.
struct FullMesh {
  std::vector<Vec3d> positions, normals;
  std::vector<std::pair<double, double>> uvs;
  std::vector<Corner> triangles;
};

/// A globe with a wavy surface. Normals are those of the globe itself.
FullMesh Blob() {
  const test::TestMesh star = test::Star(14, 24, 2);
  FullMesh blob;
  blob.triangles = star.triangles;
  for (const Vec3 p : star.positions) {
    // Half as deep valleys as the star has.
    const Vec3d direction = Normalize(ToDouble(p));
    blob.positions.push_back((ToDouble(p) + direction) * 0.5);
    blob.normals.push_back(direction);
    blob.uvs.emplace_back(direction.x + 0.5 * direction.z, direction.y);
  }
  return blob;
}

/// Each triangle cut at the middles of its sides. What is said of the middles is the mean of what
/// is said of the ends, and that is what blending over the whole triangle says there.
FullMesh Split(const FullMesh& mesh) {
  FullMesh split = mesh;
  split.triangles.clear();
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
  const auto middle = [&](uint32_t i, uint32_t j) {
    const auto [place, is_new] =
        middles.try_emplace(std::minmax(i, j), static_cast<uint32_t>(split.positions.size()));
    if (is_new) {
      split.positions.push_back((mesh.positions[i] + mesh.positions[j]) * 0.5);
      split.normals.push_back((mesh.normals[i] + mesh.normals[j]) * 0.5);
      split.uvs.emplace_back((mesh.uvs[i].first + mesh.uvs[j].first) / 2,
                             (mesh.uvs[i].second + mesh.uvs[j].second) / 2);
    }
    return place->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    split.triangles.insert(split.triangles.end(),
                           {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return split;
}

std::string ObjOf(const FullMesh& mesh) {
  std::string text;
  for (const Vec3d p : mesh.positions) text += "v " + Words(p) + "\n";
  for (const Vec3d n : mesh.normals) text += "vn " + Words(n) + "\n";
  for (const auto& [u, v] : mesh.uvs) text += fmt::format("vt {:.9g} {:.9g}\n", u, v);
  for (const Corner& corners : mesh.triangles) {
    text += "f";
    for (const uint32_t i : corners) text += fmt::format(" {0}/{0}/{0}", i + 1);
    text += "\n";
  }
  return text;
}

/// A sky with a bright spot, and everything brighter towards +x.
Image Sky(bool is_mirrored) {
  Image sky(32, 16, 3);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 32; ++x) {
      const int column = is_mirrored ? 31 - x : x;
      for (int c = 0; c < 3; ++c) {
        sky.At(column, y, c) = 0.1f + 0.02f * static_cast<float>(x) * static_cast<float>(c + 1);
        if (x == 20 && y == 4) sky.At(column, y, c) = 60;
      }
    }
  }
  return sky;
}

}  // namespace

std::vector<SceneRow> Scenes() {
  return {
      {"DiffuseUnderARectangle", "type diffuse", "type diffuse albedo 0.8 0.4 0.2", "rectangle"},
      {"ClayUnderASphere", "type diffuse roughness 0.9", "type diffuse", "sphere"},
      {"MirrorsUnderADisk", "type mirror", "type mirror reflectance 0.7 0.8 0.9", "disk"},
      {"GoldUnderATriangle", "type conductor metal gold roughness 0.3", "type diffuse",
       "triangle rectangle"},
      {"BrushedMetalUnderTheSky", "type diffuse",
       "type conductor metal iron alpha_x 0.5 alpha_y 0.1 rotation 20", "", "even"},
      {"GlassUnderTheSky", "type dielectric", "type dielectric ior water", "", "even"},
      {"GroundGlass", "type dielectric roughness 0.5", "type diffuse", "rectangle", "even"},
      {"TintedGlass", "type dielectric absorption {per_length} 0 {per_length}", "type diffuse", "",
       "even"},
      {"PlasticUnderAMesh", "type plastic albedo 0.2 0.4 0.8", "type plastic roughness 0.4",
       "mesh"},
      {"PanesUnderTheSky",
       "type dielectric thin true thickness {tenth} absorption {per_length} 0 0", "type diffuse",
       "sphere", "even"},
      {"MixtureUnderTheSun", "type mix first rough second shiny amount 0.4", "type diffuse", "sun"},
      {"VeilUnderASoftSun", "type mask material rough opacity texture checks", "type diffuse",
       "soft_sun"},
      {"ChecksUnderAPointLight", "type diffuse albedo texture checks",
       "type diffuse albedo texture checks", "point"},
      {"BumpsUnderASpot", "type diffuse bump_map texture checks bump_height {tenth}",
       "type diffuse", "spot"},
      {"BentNormalsUnderALamp", "type diffuse normal_map texture leaning",
       "type diffuse normal_map texture leaning", "rectangle disk"},
      {"DiffuseUnderAPicture", "type diffuse", "type diffuse albedo 0.7 0.7 0.7", "", "picture"},
      {"MetalUnderAPicture", "type conductor metal silver roughness 0.4", "type plastic", "",
       "picture"},
      {"AllLights", "type diffuse", "type diffuse",
       "rectangle sphere disk triangle mesh point spot sun"},
      {"OutOfFocus", "type diffuse", "type conductor metal copper roughness 0.5",
       "rectangle sphere", "", "aperture {tenth} focus_distance {near}"},
      {"OutOfFocusUnderAPicture", "type plastic roughness 0.3", "type diffuse", "", "picture",
       "aperture {tenth} focus_distance {near}"},
  };
}

std::string ChangedScene(const SceneRow& row, Change change) {
  const Placement placement = PlacementOf(change, std::string_view(row.sky) == "picture");
  const std::string mesh = change == Change::kSplit ? "blob_split.obj" : "blob.obj";
  const std::string other_mesh = change == Change::kCopy ? "blob_copy.obj" : mesh;

  std::vector<std::string> objects = {
      Node("", "floor", Object("plane normal 0 1 0 offset -1")),
      Node("translate -1 -0.3 -0.5 z_rotate 20", "ball", Object("sphere radius 0.7")),
      Node("translate 0.8 -0.2 -1.2 y_rotate 20 scale 0.8 0.8 0.8", "blobs",
           Object("mesh obj_file " + mesh)),
      Node("translate 0.5 -0.6 0.8 x_rotate 70 scale 0.4 0.4 0.4", "blobs",
           Object("mesh obj_file " + other_mesh)),
  };
  if (change == Change::kReorder) std::reverse(objects.begin(), objects.end());

  const auto lights = LightNodes(placement, mesh);
  std::string light_nodes;
  for (std::string_view names = row.lights; !names.empty();) {
    const size_t end = std::min(names.find(' '), names.size());
    light_nodes += lights.at(std::string(names.substr(0, end)));
    names.remove_prefix(std::min(end + 1, names.size()));
  }
  if (change == Change::kReorder) {
    objects.insert(objects.begin() + 2, light_nodes);
  } else {
    objects.push_back(light_nodes);
  }
  return fmt::format(
      "{}{}Textures {{ Texture {{ name checks type checker even 0.8 0.7 0.6 odd 0.2 0.2 0.3 "
      "scale 5 5 }}\nTexture {{ name leaning type checker even 0.6 0.5 0.9 odd 0.4 0.6 0.9 "
      "scale 4 4 }} }}\n"
      "Materials {{ Material {{ name floor type diffuse albedo texture checks }}\n"
      "Material {{ name black type diffuse albedo 0 0 0 }}\n"
      "Material {{ name rough type diffuse albedo 0.7 0.6 0.5 }}\n"
      "Material {{ name shiny type conductor metal gold roughness 0.3 }}\n"
      "Material {{ name ball {} }}\nMaterial {{ name blobs {} }} }}\n"
      "Scene {{ Transform {{ {} }}\n{} }}\n",
      CameraText(row, placement), Background(row, placement), InUnits(row.ball, placement.scale),
      InUnits(row.blobs, placement.scale), placement.steps, fmt::join(objects, ""));
}

void PutFiles(const std::filesystem::path& folder) {
  const FullMesh blob = Blob();
  testing_support::Put(folder / "blob.obj", ObjOf(blob));
  testing_support::Put(folder / "blob_copy.obj", "# a file of its own\n" + ObjOf(blob));
  testing_support::Put(folder / "blob_split.obj", ObjOf(Split(blob)));
  testing_support::Put(folder / "sky.pfm", *EncodeImage(Sky(false), ImageFormat::kPfm));
  testing_support::Put(folder / "sky_mirrored.pfm", *EncodeImage(Sky(true), ImageFormat::kPfm));
}

}  // namespace candela::invariance
