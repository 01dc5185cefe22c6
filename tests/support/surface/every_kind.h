// tests/support/surface/every_kind.h: all patch kinds and projection methods, for tests that try them all.
#pragma once

#include <array>

#include "sinew/rig/rig.h"
#include "sinew/surface/projection_kind.h"

namespace sinew::test {

inline constexpr std::array kEveryPatch{PatchKind::kPn, PatchKind::kPhong, PatchKind::kSpherigon, PatchKind::kFlat};
inline constexpr std::array kEveryProjection{ProjectionKind::kNewton, ProjectionKind::kBisection,
                                             ProjectionKind::kAnalytic};

}  // namespace sinew::test
