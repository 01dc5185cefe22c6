// core/geometry/dispatch.h: from an instruction set to what was compiled for it. After hwy/foreach_target.h.
#pragma once

#include "core/geometry/instruction_set.h"
#include "hwy/highway.h"

/// Body of a function that returns the set's `name`, a function or a constant of namespace sinew::HWY_NAMESPACE.
#define SINEW_RETURN_BY_SET(set, name) \
  switch (set) {                       \
    case InstructionSet::kAvx512:      \
      return N_AVX3::name;             \
    case InstructionSet::kAvx2:        \
      return N_AVX2::name;             \
    default:                           \
      return N_SSE4::name;             \
  }
