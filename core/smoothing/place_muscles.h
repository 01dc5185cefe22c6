// core/smoothing/place_muscles.h: the muscles of a pose without its mesh, for those who skin by other means.
#pragma once

#include <memory>

#include "core/smoothing/posed_field.h"

namespace sinew {

/// What poseFieldAndSkin does, but for the skinned mesh, which it leaves as it is.
/// @param rig  as there
void placeMuscles(const std::shared_ptr<const Preparation>& preparation, const PosedRig& rig, PosedField& out);

}  // namespace sinew
