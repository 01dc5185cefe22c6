// core/files/gltf/vrm_character.h: a .vrm file's bones and expressions, found on the imported character.
#pragma once

#include <span>
#include <vector>

#include "core/files/gltf/morph.h"
#include "core/files/gltf/refusal.h"
#include "core/files/gltf/skin.h"
#include "core/files/gltf/vrm.h"
#include "sinew/character/body_part.h"

namespace sinew::gltf {

/// Those of parts that Sinew knows, each once. Nodes that are no bones are noted.
[[nodiscard]] std::vector<BodyPart> bodyPartsOf(const Vrm& vrm, const BoundSkeleton& bound, Notes& notes);

/// Expressions that move a target; names are unlike those of targets. At most kMaxMorphTargets.
[[nodiscard]] std::vector<MorphSet> morphSetsOf(const Vrm& vrm, const NodeTree& tree,
                                                std::span<const MorphTarget> targets);

}  // namespace sinew::gltf
