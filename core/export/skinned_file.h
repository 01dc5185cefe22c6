// core/export/skinned_file.h: the source file with the bind pose's surface and its weights in place of its meshes.
#pragma once

#include <string>
#include <vector>

#include "core/export/fit/joint_fit.h"
#include "core/export/gltf_rewrite.h"
#include "core/export/source.h"
#include "sinew/export/skinned_export.h"

namespace sinew::exporting {

struct SkinnedFile {
  PackedGltf packed;
  int joints = 0;
  std::int64_t vertices = 0;
  std::int64_t triangles = 0;
  std::vector<std::string> left;  ///< SkinnedExportReport::left
};

/// @param fit   after measure()  @param mesh  the character's
/// Throws gltf::Refusal.
[[nodiscard]] SkinnedFile skinnedFile(Source& source, const ControlMesh& mesh, const JointFit& fit,
                                      const SkinnedExportSettings& settings);

}  // namespace sinew::exporting
