// app/panels/panel_ui.h: what every panel is handed, and the controls that run actions.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <imgui.h>

#include "app/editor/actions.h"
#include "app/editor/editor_state.h"
#include "app/panels/palette_controls.h"
#include "app/ui/ui.h"

namespace sinew::app {

// Rows and buttons that dialogs have in common.

/// The button that Enter would mean.
[[nodiscard]] bool accentButton(const char* label, const ImVec2& size);
/// A row's name; what follows stands `width` design pixels from the left.
void dialogLabel(Ui& ui, const char* text, float width);
/// What a row means, below it, with some space after it.
void dialogExplain(Ui& ui, const char* text, float width);

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

// A list of bones to choose from: near ones first, the rest by typing.

/// Inside a list that has just been opened: bones to choose from, the nearest in the tree first; typing leaves those
/// that have the text in their names, Enter takes the first. Rows note themselves as ID/NAME. @param near  -1: in the
/// tree's order; @param chosen  marked, or -1
/// @param drawOthers  what else the list offers, under the search @return the bone that was taken, or -1
[[nodiscard]] int boneList(PanelUi& ui, const std::string& id, int near, int chosen,
                           const std::function<bool(int)>& isOffered, const std::function<void()>& drawOthers = {});

}  // namespace sinew::app
