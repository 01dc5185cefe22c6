// core/files/export/file_morphs.h: the file's morph targets on the written meshes, and keys for what the rig adds to
// them.
#pragma once

#include <span>

#include "core/files/export/gltf_rewrite.h"
#include "core/files/export/out_skins.h"
#include "core/files/export/skinned_file.h"
#include "core/files/export/source.h"
#include "core/files/fit/refined_targets.h"

namespace sinew::exporting {

struct FileMorphs {
  const Source& source;
  const PlayedMorphs& played;
  const Surface& bind;  ///< Without any.
  bool refined = true;  ///< Else the meshes have their own targets still.
};

/// Targets of refined meshes, under their names; weights and keys of the nodes that the rig changes.
void addFileMorphs(const FileMorphs& morphs, std::span<const OutPrimitive> primitives, const OutSkins& skins,
                   GltfRewrite& rewrite);

}  // namespace sinew::exporting
