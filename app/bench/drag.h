// app/bench/drag.h: what a frame of a drag costs beside drawing, with short and long history, few and many muscles.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/character/character.h"

namespace sinew::app {

struct DragTrial {
  std::string scene;
  std::shared_ptr<const Character> character;
  int frames = 60;  ///< Of a drag.
  int rounds = 5;   ///< Drags.
};

/// One situation. Seconds are medians of all timed frames.
struct DragRow {
  std::string scene;
  int undoSteps = 0;
  int untouched = 0;            ///< Muscles beside the one that is dragged.
  double frameSeconds = 0.0;    ///< Edit, pose, prepare, smooth.
  double prepareSeconds = 0.0;  ///< Of which prepare.
  double projected = 0.0;       ///< Vertices a root was sought for, mean of the frames.
  double frameRatio = 1.0;      ///< Over the first row's for the same frame in the same round, median.
};

/// Drags one muscle of a trialRig at depth 5 through the command stack and the editor's live surface, while the first
/// clip plays (else in the bind pose): with 5 undo steps and 10 untouched muscles; with 200 steps; with 60 muscles.
/// Every frame is made in all three situations in turn, so that a slow moment of the machine meets them alike.
/// Error: the character has no skin to lay muscles in, or the rig was refused.
[[nodiscard]] Result<std::vector<DragRow>> measureDrag(const DragTrial& trial);

[[nodiscard]] std::string tableOf(const std::vector<DragRow>& rows);

}  // namespace sinew::app
