// app/panels/panel_ui.h: what every panel is handed, and the controls that run actions.
#pragma once

#include <imgui.h>

#include <filesystem>
#include <string>
#include <vector>

#include "app/editor/actions.h"
#include "app/editor/editor_state.h"
#include "app/panels/palette_controls.h"
#include "app/ui/ui.h"

namespace sinew::app {

/// The interface and the editor behind it, for the length of a frame.
struct PanelUi : Ui {
  EditorState& state;
  std::vector<glm::vec4>
      covered;  ///< What is drawn over the picture by hand: low x and y, high x and y, on the screen.

  PanelUi(EditorState& editor, WidgetLog& log, const Fonts& letters)
      : Ui{log, letters, editor.frame.uiScale}, state(editor) {}
};

/// The thumbnail of a document as it is on the disk, last changed then; 0: there is none.
[[nodiscard]] ImTextureID thumbnailOf(const PanelUi& ui, const std::filesystem::path& document,
                                      std::filesystem::file_time_type changed);
/// A key of the action goes down in this frame, though a dialog that takes all keys is in front.
[[nodiscard]] bool keyPressed(const PanelUi& ui, const Action& action);
/// ... is held down, whatever else is, and no text is typed.
[[nodiscard]] bool keyHeld(const PanelUi& ui, const Action& action);

/// "press M", with the key that the user has; without one, "choose Add muscle".
[[nodiscard]] std::string howToStart(const PanelUi& ui, const Action& action);
/// Label, key (in the user's keymap) and hint of an action, and why it cannot run now.
[[nodiscard]] std::string tooltipOf(const PanelUi& ui, const Action& action);
/// Without label and key: where they can be read already.
[[nodiscard]] std::string hintOf(const PanelUi& ui, const Action& action);
/// A row with the name of its control.
inline void beginRow(PanelUi& ui, const Control& control) { beginRow(ui, control.label); }
/// iconButton for an action, with its tooltip; disabled when the action is.
void actionButton(PanelUi& ui, const std::string& id, const Action& action, Icon icon, float size);
/// pillButton for an action: filled when the action is checked.
void actionPill(PanelUi& ui, const std::string& id, const Action& action);

}  // namespace sinew::app
