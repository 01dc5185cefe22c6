// core/geometry/targets.h: the instruction sets that kernels are compiled for. Include it before any header of Highway.
#pragma once

#include "core/geometry/instruction_set.h"

#ifndef __x86_64__
#error "Sinew needs an x86-64 processor with SSE4 (core/geometry/instruction_set.h)"
#endif

// SSE4, which every machine must have (checkProcessor), AVX2 and AVX-512.
#define HWY_BASELINE_TARGETS HWY_SSE4

/// Body of a function that returns the chosen set's `name`, a function or a constant of namespace sinew::HWY_NAMESPACE.
#define SINEW_RETURN_BY_SET(set, name) \
  switch (set) {                       \
    case InstructionSet::kAvx512:      \
      return N_AVX3::name;             \
    case InstructionSet::kAvx2:        \
      return N_AVX2::name;             \
    default:                           \
      return N_SSE4::name;             \
  }
