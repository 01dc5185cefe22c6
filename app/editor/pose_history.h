// app/editor/pose_history.h: undo for poses made by hand: view state, apart from the document's steps.
#pragma once

#include <cstddef>
#include <vector>

#include "core/skeleton/pose_override.h"

namespace sinew::app {

struct EditorState;

/// Poses before and after the one that is shown, the nearest last. Of one document.
struct PoseHistory {
  std::vector<PoseOverrides> before;
  std::vector<PoseOverrides> after;
  PoseOverrides shown;
  std::size_t document = 0;  ///< EditorState::documentsOpened.
};

/// Notices what became of the pose since the last frame, whoever changed it; a drag is one step, noticed at its end.
void followPose(EditorState& state);

/// In the pose tool Ctrl+Z and Ctrl+Shift+Z are about poses, as long as there are any to go back or forward to.
[[nodiscard]] bool undoesPose(const EditorState& state);
[[nodiscard]] bool redoesPose(const EditorState& state);
void undoPose(EditorState& state);
void redoPose(EditorState& state);

}  // namespace sinew::app
