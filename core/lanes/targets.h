// core/lanes/targets.h: the instruction sets that kernels are compiled for. Before any header of Highway.
#pragma once

// SSE4, AVX2, AVX-512 and one lane at a time; vectors without a fixed size would need other tiles.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
