#include "tests/integrators/same_light_scenes.h"

#include <fmt/format.h>

namespace candela::same_light {
namespace {

const char* kPinhole = "Camera { center 0 0.6 4 direction 0 -0.25 -1 up 0 1 0 fov 45 }\n";

const char* kMedia =
    "Media { Medium { name crown ior 1.5 absorption 0.1 0.1 0.05 }\n"
    "Medium { name tea ior 1.33 absorption 0.3 0.8 1.6 }\n"
    "Medium { name bubble ior 1 } }\n";

const char* kMaterials =
    "Materials {\n"
    "Material { name grey type diffuse albedo 0.6 0.6 0.6 }\n"
    "Material { name clay type diffuse albedo 0.8 0.5 0.3 roughness 0.8 }\n"
    "Material { name mirror type mirror reflectance 0.9 0.9 0.9 }\n"
    "Material { name gold type conductor metal gold roughness 0.5 }\n"
    "Material { name brushed type conductor metal iron alpha_x 0.5 alpha_y 0.2 rotation 30 }\n"
    "Material { name plastic type plastic albedo 0.2 0.4 0.7 roughness 0.4 }\n"
    "Material { name polished type plastic albedo 0.7 0.3 0.2 }\n"
    "Material { name glass type dielectric ior 1.5 }\n"
    "Material { name amber type dielectric ior 1.5 absorption 0.2 0.6 1.5 }\n"
    "Material { name ground type dielectric ior 1.5 roughness 0.5 }\n"
    "Material { name split type dielectric ior 1.5 abbe 8 roughness 0.5 }\n"
    "Material { name pane type dielectric ior 1.5 thin true thickness 1 absorption 0.1 0.3 0.6 }\n"
    "Material { name mixed type mix first clay second mirror amount 0.3 }\n"
    "Material { name net type mask material clay opacity 0.6 }\n"
    "Material { name one_sided type diffuse albedo 0.3 0.7 0.4 two_sided false }\n"
    "Material { name one_sided_net type mask material plastic opacity 0.5 two_sided false }\n"
    "Material { name layered type principled base_color 0.7 0.4 0.2 metallic 0.3 roughness 0.5 "
    "clearcoat 0.8 clearcoat_roughness 0.3 sheen 0.6 anisotropy 0.4 }\n"
    "Material { name wax type principled base_color 0.8 0.6 0.4 transmission 0.6 roughness 0.5 }\n"
    "Material { name vest type retroreflective albedo 0.8 0.4 0.1 roughness 0.5 }\n"
    "}\n";

/// A node with an object, and what else it holds.
std::string Object(const char* material, const char* transform, const char* shape,
                   const char* more = "") {
  return fmt::format(
      "Node {{ Transform {{ {} }} Component<Object> {{ type {} }} Component<Material> {{ name {} "
      "}} "
      "{} }}\n",
      transform, shape, material, more);
}

std::string Lamp(const char* transform, const char* shape, const char* light) {
  const std::string component = fmt::format("Component<Light> {{ type area {} }}", light);
  return Object("grey", transform, shape, component.c_str());
}

/// A floor and a wall behind it, that light comes back from.
std::string Corner(const char* floor = "grey") {
  return Object(floor, "translate 0 -1 0 x_rotate -90", "rectangle width 5 height 5") +
         Object("clay", "translate 0 0.5 -2", "rectangle width 5 height 3");
}

std::string Ball(const char* material) {
  return Object(material, "translate 0.2 -0.3 0", "sphere radius 0.7");
}

/// One that a scene says is filled.
std::string Body(const char* material, const char* medium, int priority, const char* transform,
                 double radius) {
  const std::string interior =
      fmt::format("Component<Interior> {{ medium {} priority {} }}", medium, priority);
  const std::string shape = fmt::format("sphere radius {}", radius);
  return Object(material, transform, shape.c_str(), interior.c_str());
}

std::string Point() {
  return "Node { Transform { translate -1 1.6 1 } Component<Light> { type point color 5 6 7 "
         "attenuation 1 } }\n";
}

/// Paths do not find the light of a point that smooth glass throws, and light paths do, so a point
/// that shines where smooth glass is shines past it.
std::string SpotBesideTheBall() {
  return "Node { Transform { translate -1 1.6 1 } Component<Light> { type spot direction 0 -1 -0.5 "
         "angle 40 color 9 9 9 attenuation 1 } }\n";
}

std::string Moving(const char* begin, const char* end, const std::string& nodes) {
  return fmt::format("Node {{ Keyframes {{ Transform {{ {} }} Transform {{ {} }} }} {} }}\n", begin,
                     end, nodes);
}

std::string RectangleLamp() {
  return Lamp("translate 0 1.7 0.5 x_rotate 90", "rectangle width 2 height 1.6", "radiance 4 4 3");
}

std::string Scene(const std::string& body, const char* background = "",
                  const char* camera = kPinhole) {
  return std::string(camera) + background + kMedia + kMaterials + "Scene {\n" + body + "}\n";
}

constexpr const char* kSky = "Background { environment assets/environments/sky.hdr rotate 60 }\n";
constexpr const char* kEvenSky = "Background { color 0.5 0.7 0.9 ambient_light 0 0 0 }\n";

}  // namespace

std::vector<NamedScene> Scenes() {
  const std::string sphere_lamp = Lamp("translate -1 1 0.5", "sphere radius 0.5", "radiance 3 4 5");
  const std::string cube = "translate 0.2 -0.4 0 y_rotate 30 scale 0.5 0.5 0.5";
  const char* mesh = "mesh obj_file assets/assignment4/models/cube.obj";
  return {
      {"point_on_diffuse", Scene(Corner() + Ball("clay") + Point())},
      {"spot_on_plastic",
       Scene(Corner() + Ball("plastic") +
             "Node { Transform { translate 1 2 2 } Component<Light> { type spot direction -0.4 -1 "
             "-1 angle 70 blend 0.5 color 9 9 9 attenuation 1 } }\n")},
      {"sun_on_metal",
       Scene(Corner() + Ball("gold") +
             "Component<Light> { type directional direction -0.5 -1 -0.7 color 2 2 2 }\n")},
      {"soft_sun_on_brushed_metal",
       Scene(Corner() + Ball("brushed") +
             "Component<Light> { type directional direction 0.6 -1 -0.5 color 2 2 2 angle 30 }\n")},
      {"sphere_lamp", Scene(Corner() + Ball("clay") + sphere_lamp)},
      {"ellipsoid_lamp", Scene(Corner() + Lamp("translate 0 0.6 0 z_rotate 20 scale 1 0.4 0.6",
                                               "sphere radius 0.8", "radiance 2 2 2"))},
      {"rectangle_lamp", Scene(Corner() + Ball("polished") + RectangleLamp())},
      {"disk_lamp_of_one_side", Scene(Corner() + Ball("plastic") +
                                      Lamp("translate -0.5 1.6 0.5 x_rotate 75", "disk radius 0.9",
                                           "radiance 5 4 3 two_sided false"))},
      {"triangle_lamp",
       Scene(Corner() + Ball("clay") +
             Lamp("", "triangle vertex0 -1 0.5 1 vertex1 1 1.7 0.5 vertex2 -1.2 1.6 -1",
                  "radiance 5 5 5"))},
      {"mesh_lamp", Scene(Corner() + Lamp("translate -0.3 0.6 0 x_rotate 30 y_rotate 20 scale 0.5 "
                                          "0.5 0.5",
                                          mesh, "radiance 2 3 3"))},
      {"environment", Scene(Corner() + Ball("gold"), kSky)},
      {"even_sky", Scene(Corner() + Ball("plastic"), kEvenSky)},
      {"layers_under_a_lamp", Scene(Corner("vest") + Ball("layered") + RectangleLamp())},
      {"wax_under_a_lamp", Scene(Corner() + Ball("wax") + RectangleLamp())},
      {"glass", Scene(Corner() + Ball("glass") + RectangleLamp())},
      {"absorbing_glass_under_a_sky", Scene(Corner() + Ball("amber"), kEvenSky)},
      {"ground_glass", Scene(Corner() + Ball("ground") + RectangleLamp())},
      {"ground_glass_that_splits", Scene(Corner() + Ball("split") + RectangleLamp())},
      {"pane_before_a_lamp",
       Scene(Corner() + Ball("clay") + RectangleLamp() +
             Object("pane", "translate 0 1 0.5 x_rotate 80", "rectangle width 3 height 2"))},
      {"mixed_and_mask",
       Scene(Corner() + Ball("mixed") + RectangleLamp() +
             Object("net", "translate -0.6 0.3 1 y_rotate 20", "rectangle width 1 height 1"))},
      {"mask_before_a_lamp",
       Scene(Corner() + Ball("clay") + RectangleLamp() +
             Object("net", "translate 0 1 0.5 x_rotate 80", "rectangle width 3 height 2"))},
      {"masks_before_all",
       Scene(Corner() + Ball("net") + RectangleLamp() +
             Object("net", "translate 0 0.3 1.5", "rectangle width 4 height 3") +
             Object("net", "translate 0.1 0.1 1.2 y_rotate 30", "rectangle width 2 height 2"))},
      {"bodies_that_overlap",
       Scene(Corner() + RectangleLamp() + Body("glass", "crown", 3, "translate 0 -0.3 0.2", 0.6) +
             Body("ground", "tea", 1, "translate 0.5 -0.2 0.2", 0.5) +
             Body("glass", "bubble", 5, "translate -0.3 -0.2 0.5", 0.3))},
      {"lamp_and_camera_in_bodies",
       Scene(Corner() + sphere_lamp + Body("glass", "tea", 1, "translate 0 0.3 4", 1.2) +
             Body("ground", "crown", 2, "translate 0.5 -0.2 0.2", 0.7) +
             Lamp("translate 0.6 -0.2 0.2", "sphere radius 0.25", "radiance 9 9 9"))},
      {"one_sided",
       Scene(Corner() + RectangleLamp() +
             Object("one_sided", "translate -0.6 0 0.3 y_rotate 30", "rectangle width 1 height 1") +
             Object("one_sided", "translate 0.6 -0.2 0.3 y_rotate 200",
                    "rectangle width 1 height 1.4") +
             Object("one_sided_net", "translate 0 1 0.8 x_rotate 70",
                    "rectangle width 1.5 height 1"))},
      {"smooth_normals", Scene(Corner() + RectangleLamp() +
                               Object("clay", "translate 0 -0.7 0 scale 7 7 7",
                                      "mesh obj_file assets/assignment4/models/bunny_200.obj"))},
      {"several_lights_in_amber",
       Scene(Corner() + sphere_lamp + SpotBesideTheBall() +
                 Object("amber", "translate 0.8 -0.3 0.3", "sphere radius 0.65") +
                 Lamp("translate 0.8 -0.3 0.3", "sphere radius 0.3", "radiance 9 9 9"),
             kEvenSky)},
      {"thin_lens", Scene(Corner() + Ball("clay") + RectangleLamp(), "",
                          "Camera { center 0 0.6 4 direction 0 -0.25 -1 up 0.3 1 0.4 fov 45 "
                          "aperture 0.5 focus_distance 3 blades 5 }\n")},
      {"view_camera",
       Scene(Corner() + Ball("clay") + RectangleLamp(), "",
             "Camera { center 0 0.6 4 direction 0 -0.1 -1 up 0.3 1 0.4 fov 45 aperture 0.5 "
             "focus_distance 3 blades 5 blade_rotation 30 tilt 20 -50 shift 0.1 -0.4 }\n")},
      {"orthographic",
       Scene(Corner() + Ball("clay") + RectangleLamp(), "",
             "Camera { type orthographic center 0 0.6 4 direction 0.1 -0.25 -1 up 0 1 0 height 3.5 "
             "aperture 0.5 focus_distance 4 }\n")},
      {"orthographic_in_bodies",
       Scene(Corner() + sphere_lamp + Body("glass", "tea", 1, "translate 0.3 0.3 2.5", 1.2), "",
             "Camera { type orthographic center 0 0.6 2.5 direction 0 -0.25 -1 up 0 1 0 "
             "height 3.5 }\n")},
      {"fisheye",
       Scene(Corner() + Ball("clay") + RectangleLamp(), "",
             "Camera { type fisheye center 0 0.4 1.4 direction 0 -0.25 -1 up 0 1 0 fov 240 }\n")},
      {"equisolid_fisheye",
       Scene(Corner() + Ball("clay") + RectangleLamp(), "",
             "Camera { type fisheye mapping equisolid center 0 0.4 1.4 direction 0 -0.25 -1 "
             "up 0 1 0 fov 360 }\n")},
      {"panoramic",
       Scene(Corner() + Ball("clay") + RectangleLamp() +
                 Object("clay", "translate 0 0 3", "rectangle width 3 height 2"),
             "", "Camera { type panoramic center 0 0.4 1.4 direction 0.4 -0.25 -1 up 0 1 0 }\n")},
      {"point_with_falloff",
       Scene(Corner() + Ball("clay") +
             "Node { Transform { translate -1 1.6 1 } Component<Light> { type point color 5 6 7 "
             "falloff 0 0 1 } }\n")},
      {"projector",
       Scene(
           Corner() + Ball("plastic") +
               "Node { Transform { translate 1 2 2 } Component<Light> { type projector image "
               "texture slide direction -0.4 -1 -1 up 0 1 0 fov 60 aspect 1.5 color 9 9 9 "
               "attenuation 1 } }\n",
           "Textures { Texture { name slide type checker even 1 0.4 0.1 odd 0 0.2 0.6 scale 5 3 } "
           "}\n")},
      {"ies",
       Scene(Corner() + Ball("gold") +
             "Node { Transform { translate -0.4 1.8 0.6 y_rotate 200 } Component<Light> { type ies "
             "file assets/lamps/wall_washer.ies scale 0.01 } }\n")},
      {"daylight_without_sun",
       Scene(Corner() + Ball("plastic"),
             "Background { sky daylight turbidity 4 sun_elevation 50 sun_azimuth 100 "
             "ground_albedo 0.3 0.3 0.3 sun false scale 0.1 }\n")},
      {"moving",
       Scene(Corner() + RectangleLamp() +
                 Moving("translate -0.4 0 0 y_rotate 0", "translate 0.4 0 0.3 y_rotate 60",
                        Object("plastic", "translate 0 -0.3 0", "sphere radius 0.5") +
                            Object("net", "translate 0 0.6 0 scale 5 5 5",
                                   "mesh obj_file assets/assignment4/models/bunny_200.obj")),
             "",
             "Camera { center 0 0.6 4 center_end 0.6 0.8 4 direction 0 -0.25 -1 direction_end -0.1 "
             "-0.25 -1 up 0 1 0 fov 45 aperture 0.3 focus_distance 4 shutter_interval 0.1 0.9 "
             "}\n")},
      {"moving_bodies", Scene(Corner() + Point() +
                              Moving("translate 0 0 0", "translate 0 0 -2",
                                     Body("glass", "tea", 1, "translate 0 0.3 4", 1.2)) +
                              Moving("translate 0 0 0", "translate 0.5 0.3 0",
                                     Body("ground", "crown", 2, "translate 0 -0.2 0.2", 0.6)))},
  };
}

}  // namespace candela::same_light
