// core/include/sinew/rig/not_compared.h: members that are ignored when two documents are compared.
#pragma once

#include "sinew/geometry/same_version.h"

namespace sinew {

template <class T>
struct NotCompared {
  T value;

  friend constexpr bool operator==(const NotCompared&, const NotCompared&) { return true; }
};

}  // namespace sinew
