// app/editor/pose_history.cpp: poses compared from frame to frame.

#include "app/editor/pose_history.h"

#include <utility>

#include "app/editor/editor_state.h"

namespace sinew::app {
namespace {

bool isPosing(const EditorState& state) { return state.hasCharacter() && state.tools.tool == ToolKind::kPose; }

void step(EditorState& state, std::vector<PoseOverrides>& from, std::vector<PoseOverrides>& to) {
  PoseHistory& history = state.poseHistory;
  to.push_back(std::exchange(history.shown, from.back()));
  from.pop_back();
  state.transport.overrides = history.shown;
}

}  // namespace

void followPose(EditorState& state) {
  PoseHistory& history = state.poseHistory;
  if (history.document != state.documentsOpened) history = {{}, {}, state.transport.overrides, state.documentsOpened};
  if (state.tools.pose.bone >= 0 || history.shown == state.transport.overrides) return;
  history.before.push_back(std::exchange(history.shown, state.transport.overrides));
  history.after.clear();
}

bool undoesPose(const EditorState& state) { return isPosing(state) && !state.poseHistory.before.empty(); }

bool redoesPose(const EditorState& state) { return isPosing(state) && !state.poseHistory.after.empty(); }

void undoPose(EditorState& state) { step(state, state.poseHistory.before, state.poseHistory.after); }

void redoPose(EditorState& state) { step(state, state.poseHistory.after, state.poseHistory.before); }

}  // namespace sinew::app
