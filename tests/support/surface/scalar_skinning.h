// tests/support/surface/scalar_skinning.h: the reference of skinning_kernel.h: its operations in the same order,
// without vectors.
#pragma once

#include "core/character/skinning_kernel.h"

namespace sinew::test {

[[nodiscard]] SkinKernels scalarSkinKernels();

}  // namespace sinew::test
