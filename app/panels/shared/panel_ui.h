// app/panels/shared/panel_ui.h: what every panel is handed, and the controls that run actions.
#pragma once

#include <string>

#include "app/actions/actions.h"
#include "app/editor/editor_state.h"
#include "app/ui/ui.h"

namespace sinew::app {

/// The interface and the editor behind it, for the length of a frame.
struct PanelUi : Ui {
  EditorState& state;

  PanelUi(EditorState& editor, WidgetLog& log, const Fonts& letters)
      : Ui{log, letters, editor.frame.uiScale}, state(editor) {}
};

/// Label, key (in the user's keymap) and hint of an action.
[[nodiscard]] std::string tooltipOf(const PanelUi& ui, const Action& action);
/// iconButton for an action, with its tooltip; disabled when the action is.
void actionButton(PanelUi& ui, const std::string& id, const Action& action, Icon icon, float size);
/// pillButton for an action: filled when the action is checked.
void actionPill(PanelUi& ui, const std::string& id, const Action& action);

}  // namespace sinew::app
