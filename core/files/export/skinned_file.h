// core/files/export/skinned_file.h: the source file with the bind pose's surface and its weights in place of its
// meshes.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/files/export/gltf_rewrite.h"
#include "core/files/export/out_skins.h"
#include "core/files/export/source.h"
#include "core/files/fit/joint_fit.h"
#include "sinew/files/skinned_export.h"

namespace sinew::exporting {

struct SkinnedFile {
  PackedGltf packed;
  int joints = 0;
  std::int64_t vertices = 0;
  std::int64_t triangles = 0;
  std::vector<std::string> left;  ///< SkinnedExportReport::left
};

/// A refined primitive as it stands in the file.
struct OutPrimitive {
  int node = 0;              ///< The file's node that shows the primitive's mesh.
  int place = 0;             ///< Among the mesh's primitives.
  std::vector<int> refined;  ///< [n] refined vertex that each vertex shows.
  std::vector<int> drawn;    ///< [n] drawn vertex whose shading normal it has.
};

/// What else is to be done to the file before it is packed.
using FinishFile = std::function<void(GltfRewrite& rewrite, const OutSkins& skins, std::span<const OutPrimitive>)>;

/// @param fit   after measure()  @param character  as requireSame() has found it; clips added from other files come
/// after the file's Throws gltf::Refusal.
[[nodiscard]] SkinnedFile skinnedFile(Source& source, const Character& character, const JointFit& fit,
                                      const SkinnedExportSettings& settings, const FinishFile& finish = {});

}  // namespace sinew::exporting
