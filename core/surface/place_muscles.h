// core/surface/place_muscles.h: the muscles of a pose without its mesh, for those who skin by other means.
#pragma once

#include <memory>
#include <vector>

#include "core/surface/posed_field.h"

namespace sinew {

/// What poseFieldAndSkin does, but for the skinned mesh, which it leaves as it is.
/// @param rig  as there
void placeMuscles(const std::shared_ptr<const Preparation>& preparation, const PosedRig& rig, PosedField& out);

/// The primitives alone: reads nothing that follows from a mesh or a bind pose.
/// @param numbers  scratch.  @param out [A] world
void posePrimitives(const Preparation& preparation, const PosedRig& rig, std::vector<FieldPrimitive>& numbers,
                    std::vector<PosedPrimitive>& out);

}  // namespace sinew
