// core/geometry/targets.h: the instruction sets that kernels are compiled for. Before any header of Highway.
#pragma once

#ifndef __x86_64__
#error "Sinew needs an x86-64 processor with SSE4 (core/geometry/instruction_set.h)"
#endif

// SSE4, which every machine must have (checkProcessor), AVX2 and AVX-512.
#define HWY_BASELINE_TARGETS HWY_SSE4
