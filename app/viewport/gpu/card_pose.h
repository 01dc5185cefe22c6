// app/viewport/gpu/card_pose.h: what a pose is on the graphics card: matrices of the bones and placed muscles.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "app/viewport/gpu/card_layout.h"
#include "core/surface/posed_field.h"
#include "sinew/character/pose.h"

namespace sinew::app {

/// Memory that is kept from pose to pose.
struct PosedMuscles {
  PosedRig rig;
  PosedField field;  ///< Without the skinned mesh.
};

/// Poses the rig; morph targets are added up here too.
/// @return why this pose is left to the processor, or nullopt
[[nodiscard]] std::optional<std::string> poseMuscles(const std::shared_ptr<const Preparation>& preparation,
                                                     const Pose& pose, PosedMuscles& out);

/// @param out [bindings] from the bind pose to the pose
void fillMatrices(const Preparation& preparation, const Pose& pose, std::span<glm::mat4> out);
/// @param out [primitives]
void fillPrimitives(const Preparation& preparation, const PosedField& field, std::span<card::Primitive> out);

}  // namespace sinew::app
