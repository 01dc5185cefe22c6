// app/editor/pose_commands.h: edits of a pose made by hand; the range of motion.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// A rotation by the joint's file name (Skeleton::fileName), for other characters.
using NamedTurn = std::pair<std::string, glm::quat>;
[[nodiscard]] std::vector<NamedTurn> namedTurns(const PoseOverrides& overrides, const Skeleton& skeleton);
struct FoundTurns {
  PoseOverrides overrides;
  int missing = 0;  ///< Joints that the skeleton lacks.
};
[[nodiscard]] FoundTurns turnsOf(const std::vector<NamedTurn>& turns, TurnsFrom from, const Skeleton& skeleton);

void resetJoint(EditorState& state);  ///< Returns the selected joint to the clip or bind pose.
void resetPose(EditorState& state);
void mirrorPose(EditorState& state);      ///< Copies the selected joint's side to the other; without one swaps sides.
void copyPose(EditorState& state);        ///< By joint names.
void pastePose(EditorState& state);       ///< Replaces the pose, without joints that this character lacks.
void toggleHoldPose(EditorState& state);  ///< Rotated joints follow the clip or keep still; the pose does not change.
void selectParentJoint(Document& document);  ///< Without a selection, the root.
void selectChildJoint(EditorState& state);   ///< The first child that is not hidden (hiddenBones()).

[[nodiscard]] bool isPosed(const EditorState& state);
[[nodiscard]] bool selectedJointIsPosed(const EditorState& state);

/// Plays the clip "Range of motion", which is made from the skeleton unless the character has one.
void playRangeOfMotion(EditorState& state);

}  // namespace sinew::app
