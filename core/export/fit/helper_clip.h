// core/export/fit/helper_clip.h: how the added joints move in a clip.
#pragma once

#include <string>
#include <vector>

#include "core/export/fit/trs.h"

namespace sinew::exporting {

struct HelperClip {
  std::string clip;
  std::vector<float> times;              ///< [keys] seconds, rising.
  std::vector<std::vector<Trs>> locals;  ///< [joints][keys] in their parents' spaces.
};

}  // namespace sinew::exporting
