// app/editor/pose_commands.h: what can be done with a pose made by hand.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// A turn that outlives its character: by the joint's name in the file (Skeleton::fileName).
using NamedTurn = std::pair<std::string, glm::quat>;
[[nodiscard]] std::vector<NamedTurn> namedTurns(const PoseOverrides& overrides, const Skeleton& skeleton);
struct FoundTurns {
  PoseOverrides overrides;
  int missing = 0;  ///< Joints that this skeleton does not have.
};
[[nodiscard]] FoundTurns turnsOf(const std::vector<NamedTurn>& turns, TurnsFrom from, const Skeleton& skeleton);

/// The selected joint goes back to the clip's, or bind, rotation.
void resetJoint(EditorState& state);
/// All joints do.
void resetPose(EditorState& state);
/// With a joint of one side selected its whole side goes to the other; else left and right change places.
void mirrorPose(EditorState& state);
/// By joint names, so that it fits other characters of the same skeleton.
void copyPose(EditorState& state);
/// Replaces the pose; joints that this character lacks are left out.
void pastePose(EditorState& state);
/// Turned joints follow the clip, or stand still under it; this moment looks the same before and after.
void toggleHoldPose(EditorState& state);
/// Selects the joint above, or the first below, the selected one; the first root where none is.
void selectParentJoint(Document& document);
/// The first that is not hidden (hidden_bones.h).
void selectChildJoint(EditorState& state);

[[nodiscard]] bool isPosed(const EditorState& state);
[[nodiscard]] bool selectedJointIsPosed(const EditorState& state);

/// Chooses the clip "Range of motion", made from the skeleton if the character has none of that name, and plays it.
void playRangeOfMotion(EditorState& state);

}  // namespace sinew::app
