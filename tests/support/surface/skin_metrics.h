// tests/support/surface/skin_metrics.h: how smooth a shaded surface looks, in numbers.
#pragma once

#include "sinew/surface/surface.h"

namespace sinew::test {

/// Counts over moved vertices, their edges and triangles, summed over poses. "exact" is the same surface shaded with
/// the field's own normals.
struct SkinMetrics {
  int refined = 0;         ///< Vertices of a surface.
  long long vertices = 0;  ///< Moved by the muscles.
  long long off = 0;       ///< Shading normal 10 degrees further from the faces' than the patch's own is.
  long long exactOff = 0;
  long long edges = 0;     ///< At moved vertices.
  long long swinging = 0;  ///< Edges whose shading normals turn 10 degrees more than the faces' and the patch's do.
  long long exactSwinging = 0;
  long long swingingAtAll = 0;  ///< ... than the faces' alone: a coarse patch does so without muscles.
  long long triangles = 0;      ///< All.
  long long turned = 0;         ///< Turned over against their patch, where the patch itself does not fold.
  long long turnedInFolds = 0;
  double definition = 0.0;  ///< Degrees between the shading normal and the patch's, summed over the moved vertices
                            ///< that folds left alone.
  double exactDefinition = 0.0;

  void add(const SkinMetrics& other);
};

/// @param patch  the same pose without muscles.  @param exact  the same before folds and shading (projected.h).
[[nodiscard]] SkinMetrics skinMetrics(const Surface& surface, const Surface& patch, const Surface& exact);

}  // namespace sinew::test
