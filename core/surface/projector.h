// core/surface/projector.h: the ways to move a patch's vertices onto the surface, as a table.
#pragma once

#include <span>

#include "core/surface/posed_field.h"
#include "core/surface/workspace.h"

namespace sinew {

/// Where vertices go in one pose.
struct Projection {
  const Preparation& preparation;
  const PosedField& posed;
  FieldView field;  ///< Muscles that are seen, and carriers that are not asked for.
};

/// One way to compute what both modes define. They agree as docs/design.md promises (Projection): to 1e-6 H.
struct Projector {
  const char* name;
  /// `surface` holds the patch on entry; fills positions, normals, displacement and counts in the report.
  void (*project)(const Projection& projection, const Pose& pose, Workspace& workspace, Surface& surface);
};

/// "scalar": one vertex after the other in double precision: the reference, which has every ProjectionKind. "vectors":
/// 16 vertices at a time, by newton.
[[nodiscard]] std::span<const Projector> projectors();
/// By the instruction set that is chosen for this process (core/geometry/instruction_set.h); scalar but for newton.
[[nodiscard]] const Projector& chosenProjector(const Preparation& preparation);

}  // namespace sinew
