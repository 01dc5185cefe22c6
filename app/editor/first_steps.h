// app/editor/first_steps.h: Help > First steps: five things to try, each done when it is done, in any order.
#pragma once

#include "app/editor/editor_state.h"

namespace sinew::app {

enum class FirstStep : std::size_t { kTurn, kSelect, kScale, kAdd, kCompare };

/// Opens the first sample and shows the list; or puts it away. Unsaved changes are asked about first.
void toggleFirstSteps(EditorState& state);

/// Once a frame while the list is shown: ticks off what has been done to the open document since it was opened.
void followFirstSteps(EditorState& state);
[[nodiscard]] bool firstStepsDone(const FirstStepsState& steps);

}  // namespace sinew::app
