// core/files/export/skinned_file.h: the source file with its meshes replaced by the surface of the bind pose.
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

struct OutPrimitive {
  int node = 0;              ///< The file's node that shows the mesh.
  int place = 0;             ///< Index in the mesh.
  std::vector<int> refined;  ///< [n] refined vertex of each vertex.
  std::vector<int> drawn;    ///< [n] drawn vertex with its shading normal.
};

/// Further changes before packing.
using FinishFile = std::function<void(GltfRewrite& rewrite, const OutSkins& skins, std::span<const OutPrimitive>)>;

/// Clips added from other files come after the file's. Throws gltf::Refusal. @param fit  after measure()
[[nodiscard]] SkinnedFile skinnedFile(Source& source, const Character& character, const JointFit& fit,
                                      const SkinnedExportSettings& settings, const FinishFile& finish = {});

}  // namespace sinew::exporting
