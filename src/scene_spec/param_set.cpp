#include "scene_spec/param_set.h"

#include <algorithm>

namespace candela {

const Param* ParamSet::Find(std::string_view name) const {
  const auto found = std::find_if(params.rbegin(), params.rend(),
                                  [&](const Param& param) { return param.name == name; });
  return found == params.rend() ? nullptr : &*found;
}

}  // namespace candela
