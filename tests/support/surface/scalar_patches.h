// tests/support/surface/scalar_patches.h: the reference of patch_kernel.cpp: its operations in the same order, without
// vectors.
#pragma once

#include "core/surface/patches/patch.h"

namespace sinew::test {

[[nodiscard]] PatchKernels scalarPatchKernels();

}  // namespace sinew::test
