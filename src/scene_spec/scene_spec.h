#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/mat4.h"
#include "math/spectrum.h"
#include "scene_spec/light_group.h"
#include "scene_spec/mesh_spec.h"
#include "scene_spec/param_set.h"

namespace candela {

/// A clear sky and the sun in it, by day.
struct SkySpec {
  /// The range for which there is a model.
  static constexpr float kLeastTurbidity = 2, kMostTurbidity = 10;

  float turbidity = 3;                  ///< How hazy it is.
  float sun_elevation_degrees = 45;     ///< Above the horizon; from 0 to 90.
  float sun_azimuth_degrees = 0;        ///< From -z over +x.
  Rgb ground_albedo{0.2f, 0.2f, 0.2f};  ///< Of what lies below the horizon; each from 0 to 1.
  bool has_sun = true;  ///< Whether the sun shines; the sky is as bright without it.
};

/// Fog: what a ray sees fades into its colour, as much as there is of it along the ray.
struct FogSpec {
  enum class Profile {
    kHomogeneous,  ///< As dense everywhere.
    kExponential,  ///< `density` at `base`, less by a factor of e for each `height` above it.
    kLinear,       ///< `density` up to `base`, from there evenly less, to nothing `height` above.
  };
  /// What scenes call them, in their order.
  static constexpr std::string_view kProfileWords[] = {"homogeneous", "exponential", "linear"};

  Profile profile = Profile::kHomogeneous;
  Rgb color{0.5f, 0.5f, 0.5f};  ///< Not negative.
  float density = 0;            ///< The optical depth per unit of length; not negative.
  float base = 0;               ///< In y.
  float height = 1;             ///< Above 0.
  SourceLocation where;
};

/// What rays see that hit nothing, and the light that is everywhere.
struct BackgroundSpec {
  Rgb color;
  Rgb ambient_light;
  /// Folder with the six faces, relative to that of the scene; replaces `color`.
  std::string cube_map;
  SourceLocation cube_map_where;
  /// A picture in longitude and latitude, relative to the folder too; replaces `color` too.
  std::string environment;
  SourceLocation environment_where;
  float environment_scale = 1;           ///< Multiplies its radiance, or the sky's; not negative.
  float environment_rotate_degrees = 0;  ///< About +y, counter-clockwise seen from above.
  /// Replaces `color` as well; there is one of the three at most.
  std::optional<SkySpec> sky;
  std::optional<FogSpec> fog;
  LightGroup light_group;  ///< Of the sun as well.
};

/// A texture with the name that materials and further textures use for it.
struct TextureSpec {
  TypedSpec texture;
  std::string name;
  SourceLocation name_where;
};

/// A medium with the name that interiors use for it.
struct MediumSpec {
  ParamSet params;
  SourceLocation where;
  std::string name;
  SourceLocation name_where;
};

/// What fills the object of a node.
struct InteriorSpec {
  ParamSet params;
  SourceLocation where;
};

/// A material with the name that nodes may use for it.
struct MaterialSpec {
  TypedSpec material;
  std::string name;  ///< Empty when it has none; then only its index refers to it.
  SourceLocation name_where;
};

/// Which material an object wears: by position in `SceneSpec::materials`, or by name.
struct MaterialReference {
  std::string name;              ///< Counts when it is not empty.
  std::optional<int64_t> index;  ///< Nothing when it could not be read, which was reported.
  SourceLocation where;
};

/// A node of the hierarchy. Whatever it holds stands in its own coordinates.
struct NodeSpec {
  static constexpr uint32_t kNoParent = 0xFFFFFFFF;

  uint32_t parent = kNoParent;
  /// At how many moments at most it is said where something is that moves.
  static constexpr size_t kMostSteps = 1000;

  Mat4 parent_from_node = Mat4::Identity();
  /// Of a node that moves, in place of it: the matrices at times evenly spread over 0 to 1, two to
  /// `kMostSteps`, linear element by element in between. Else empty.
  std::vector<Mat4> motion;
  SourceLocation transform_where;
  std::optional<TypedSpec> object;
  std::optional<TypedSpec> light;
  std::optional<MaterialReference> material;
  std::optional<InteriorSpec> interior;
};

/// A block of parameters as it was read: what they are called and may be is for those to know who
/// use it.
struct BlockSpec {
  ParamSet params;
  SourceLocation where;  ///< Of the last such block.
  bool is_given = false;
};

/// A scene as its file describes it: plain, editable data without meaning beyond its grammar.
/// `CompileScene` makes a `Scene` of it.
struct SceneSpec {
  std::filesystem::path folder;  ///< Where the scene lies; see `PathInScene`.
  SourceLocation file;           ///< The file as a whole, for messages.
  TypedSpec camera;              ///< Without a type when the scene has none, which was reported.
  BackgroundSpec background;
  /// How the scene is meant to be rendered, for programs that let scenes say so.
  BlockSpec render, film;
  /// In the order of the file, in which a texture may use those above it.
  std::vector<TextureSpec> textures;
  /// As `materials_are_damaged`.
  bool textures_are_damaged = false;
  std::vector<MaterialSpec> materials;
  /// True when some could not be read, which was reported: a reference to one that is missing is
  /// then no mistake of its own.
  bool materials_are_damaged = false;
  std::vector<MediumSpec> media;
  /// As `materials_are_damaged`.
  bool media_are_damaged = false;
  /// Whether a place lies in the file of the scene itself, not in one that it includes.
  bool IsInSceneFile(const SourceLocation& where) const;
  /// A path that stands in the scene or in a file that it includes, relative to `folder`: paths are
  /// meant relative to the file in which they stand. Absolute ones and the empty one stay; those of
  /// a file that was included by an absolute path may become absolute.
  std::string PathInScene(const ParamWord& path) const;

  /// The hierarchy in the order of the file: each node after its parent. The first is the root.
  std::vector<NodeSpec> nodes;
  /// The meshes by `PathInScene`; null when one could not be read, which was reported.
  /// Paths that mean the same file share one mesh.
  std::map<std::string, std::shared_ptr<const MeshSpec>> meshes;
  /// The files that were read, the one of the scene first, then those that it includes.
  std::vector<std::filesystem::path> files;
  /// The files of which the names of materials were read, for warnings alone.
  std::vector<std::filesystem::path> mtl_files;
};

}  // namespace candela
