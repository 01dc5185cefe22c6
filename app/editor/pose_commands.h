// app/editor/pose_commands.h: what can be done with a pose made by hand.
#pragma once

#include "app/editor/editor_state.h"

namespace sinew::app {

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
void selectChildJoint(Document& document);

[[nodiscard]] bool isPosed(const EditorState& state);
[[nodiscard]] bool selectedJointIsPosed(const EditorState& state);

/// Chooses the clip "Range of motion", made from the skeleton if the character has none of that name, and plays it.
void playRangeOfMotion(EditorState& state);

}  // namespace sinew::app
