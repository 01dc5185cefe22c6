// core/lanes/dispatch.h: from an instruction set to what was compiled for it. After hwy/foreach_target.h.
#pragma once

#include "core/lanes/instruction_set.h"
#include "hwy/highway.h"

#if HWY_TARGETS & HWY_AVX3
#define SINEW_FOR_AVX512(name)  \
  case InstructionSet::kAvx512: \
    return N_AVX3::name;
#else
#define SINEW_FOR_AVX512(name)
#endif
#if HWY_TARGETS & HWY_AVX2
#define SINEW_FOR_AVX2(name)  \
  case InstructionSet::kAvx2: \
    return N_AVX2::name;
#else
#define SINEW_FOR_AVX2(name)
#endif
#if HWY_TARGETS & HWY_SSE4
#define SINEW_FOR_SSE4(name)  \
  case InstructionSet::kSse4: \
    return N_SSE4::name;
#else
#define SINEW_FOR_SSE4(name)
#endif

/// Body of a function that returns the set's `name`, a function or a constant of namespace sinew::HWY_NAMESPACE.
#define SINEW_RETURN_BY_SET(set, name)  \
  switch (set) {                        \
    SINEW_FOR_AVX512(name)              \
    SINEW_FOR_AVX2(name)                \
    SINEW_FOR_SSE4(name)                \
    default:                            \
      return HWY_STATIC_DISPATCH(name); \
  }
