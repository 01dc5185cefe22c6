// core/export/skinned_file.h: the source file with the bind pose's surface and its weights in place of its meshes.
#pragma once

#include <string>
#include <vector>

#include "core/export/four_weights.h"
#include "core/export/gltf_rewrite.h"
#include "core/export/source.h"
#include "sinew/export/skinned_export.h"
#include "sinew/smoothing/surface.h"

namespace sinew::exporting {

struct SkinnedFile {
  PackedGltf packed;
  int joints = 0;
  std::int64_t vertices = 0;
  std::int64_t triangles = 0;
  std::vector<std::string> left;  ///< SkinnedExportReport::left
};

/// @param bind     the surface in the bind pose  @param mesh  the character's
/// @param weights  [V'] or, for the file's own vertices, [V]
/// Throws gltf::Refusal.
[[nodiscard]] SkinnedFile skinnedFile(Source& source, const ControlMesh& mesh, const Surface& bind,
                                      const std::vector<FourWeights>& weights, const SkinnedExportSettings& settings);

}  // namespace sinew::exporting
