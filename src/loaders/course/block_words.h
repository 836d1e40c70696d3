#pragma once

#include <string_view>

namespace candela {

/// The words that open blocks, by the place where they may stand.
inline constexpr std::string_view kSectionWords[] = {"Background", "Camera", "Film",  "Materials",
                                                     "Media",      "Render", "Scene", "Textures"};
/// What may stand in the place of any block of a list, with the name of a file behind it.
inline constexpr std::string_view kInclude = "include";
inline constexpr std::string_view kMaterialsWords[] = {"Material"};
inline constexpr std::string_view kMediaWords[] = {"Medium"};
inline constexpr std::string_view kKeyframesWords[] = {"Transform"};
inline constexpr std::string_view kTexturesWords[] = {"Texture"};
inline constexpr std::string_view kNodeWords[] = {"Node",
                                                  "Transform",
                                                  "Keyframes",
                                                  "Component<Interior>",
                                                  "Component<Material>",
                                                  "Component<Light>",
                                                  "Component<Object>"};

}  // namespace candela
