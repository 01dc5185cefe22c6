// core/surface/projector.h: the two implementations of projection, as a table.
#pragma once

#include <span>

#include "core/surface/posed_field.h"
#include "core/surface/workspace.h"

namespace sinew {

/// Input of projection in one pose.
struct Projection {
  const Preparation& preparation;
  const PosedField& posed;
  FieldView field;  ///< Muscles in view, and carriers to leave out.
};

/// An implementation of both modes. Implementations agree to 1e-6 H (docs/design.md, Projection).
struct Projector {
  const char* name;
  /// `surface` holds the patch on entry. Fills positions, normals, displacement and the counts of the report.
  void (*project)(const Projection& projection, const Pose& pose, Workspace& workspace, Surface& surface);
};

/// "scalar", the reference: single vertices in double, every ProjectionKind. "vectors": 16 vertices at a time, newton.
[[nodiscard]] std::span<const Projector> projectors();
/// "vectors" for newton, unless the process has chosen scalar code (core/geometry/instruction_set.h); else "scalar".
[[nodiscard]] const Projector& chosenProjector(const Preparation& preparation);

}  // namespace sinew
