#pragma once

#include <string_view>

namespace candela {

/// The words that open blocks, by the place where they may stand.
inline constexpr std::string_view kSectionWords[] = {"Background", "Camera", "Materials",
                                                     "Media",      "Scene",  "Textures"};
inline constexpr std::string_view kMaterialsWords[] = {"Material"};
inline constexpr std::string_view kMediaWords[] = {"Medium"};
inline constexpr std::string_view kTexturesWords[] = {"Texture"};
inline constexpr std::string_view kNodeWords[] = {"Node",
                                                  "Transform",
                                                  "Component<Interior>",
                                                  "Component<Material>",
                                                  "Component<Light>",
                                                  "Component<Object>"};

}  // namespace candela
