// core/export/morph_targets.h: morph targets of the written primitives, and their weights in the clip.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/export/gltf_rewrite.h"
#include "core/export/skinned_file.h"

namespace sinew::exporting {

struct PrimitiveDeltas {
  std::vector<std::vector<glm::vec3>> positions;  ///< [targets][vertices]
  std::vector<std::vector<glm::vec3>> normals;    ///< [targets][vertices]
};

/// Gives every mesh of the primitives the targets; other primitives of these meshes get as many that move nothing, as
/// glTF asks. Sparse accessors where they are smaller.
/// @param deltas  one for each primitive
void addMorphTargets(std::span<const OutPrimitive> primitives, std::span<const PrimitiveDeltas> deltas,
                     const std::string& clip, GltfRewrite& rewrite);

/// A channel for each node that shows one of the primitives, linear between keys; in the file's first clip, which is
/// made where it is gone because all it had were targets that are gone.
/// @param times  [keys] seconds, rising  @param weights  [keys * targets]
void addMorphWeights(std::span<const OutPrimitive> primitives, const std::vector<float>& times,
                     const std::vector<float>& weights, const std::string& clip, GltfRewrite& rewrite);

}  // namespace sinew::exporting
