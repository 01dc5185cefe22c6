// app/panels/panel_ui.h: what every panel is handed, and the controls that panels share.
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include <imgui.h>

#include "app/editor/actions.h"
#include "app/editor/editor_state.h"
#include "app/panels/palette_controls.h"
#include "app/ui/ui.h"

namespace sinew::app {

/// The interface and the editor behind it, for the length of a frame.
struct PanelUi : Ui {
  EditorState& state;
  std::vector<glm::vec4> covered;  ///< Boxes drawn by hand over the picture: low x and y, high x and y, on the screen.

  PanelUi(EditorState& editor, WidgetLog& log, const Fonts& letters)
      : Ui{log, letters, editor.frame.uiScale}, state(editor) {}
};

/// The thumbnail of a document on disk, last changed at that time; 0: none.
[[nodiscard]] ImTextureID thumbnailOf(const PanelUi& ui, const std::filesystem::path& document,
                                      std::filesystem::file_time_type changed);
/// A key of the action goes down in this frame, even behind a dialog that takes all keys.
[[nodiscard]] bool keyPressed(const PanelUi& ui, const Action& action);
/// A key of the action is held, with or without other keys, and no text is typed.
[[nodiscard]] bool keyHeld(const PanelUi& ui, const Action& action);

/// "press M", with the user's key; "choose Add muscle" if there is none.
[[nodiscard]] std::string howToStart(const PanelUi& ui, const Action& action);
/// Label, key in the user's keymap and hint of an action, and why it cannot run now.
[[nodiscard]] std::string tooltipOf(const PanelUi& ui, const Action& action);
[[nodiscard]] std::string hintOf(const PanelUi& ui, const Action& action);  ///< The same without label and key.
/// A row named after its control.
inline void beginRow(PanelUi& ui, const Control& control) { beginRow(ui, control.label); }
/// Notes itself as `id`. @param size  0: as large as the label
[[nodiscard]] bool textButton(Ui& ui, const std::string& id, const char* label, const ImVec2& size = {0.0f, 0.0f},
                              const std::string& hint = "");
/// A switch that fills the row, as segmented(). @return the index that was clicked, or -1
[[nodiscard]] int chooseWord(Ui& ui, const char* id, std::initializer_list<const char*> words, int chosen);
/// An item of a context menu; notes itself as context/ID.
[[nodiscard]] bool contextItem(Ui& ui, const char* label, const std::string& id, bool enabled = true);
/// iconButton for an action, with its tooltip; disabled when the action is.
void actionButton(PanelUi& ui, const std::string& id, const Action& action, Icon icon, float size);
/// pillButton for an action: filled when the action is checked.
void actionPill(PanelUi& ui, const std::string& id, const Action& action);

/// A modal window with the dialog style; place it before. @param draw  its content; returns whether to close it
void drawModal(PanelUi& ui, const char* title, const std::function<bool()>& draw);
/// The button that Enter presses. Notes itself as `id`.
[[nodiscard]] bool accentButton(Ui& ui, const std::string& id, const char* label, const ImVec2& size);
/// A row's name; what follows begins `width` design pixels from the left.
void dialogLabel(Ui& ui, const char* text, float width);
void dialogExplain(Ui& ui, const char* text, float width);  ///< An explanation below a row, with some space after it.
void mutedParagraph(const std::string& text);               ///< Muted text that wraps at the window's edge.
[[nodiscard]] float buttonWidth(const char* label);         ///< Width of a button with this label, window coordinates.

/// Inside a combo that has just been opened: bones to choose from, the nearest in the tree first. Typing filters by
/// name, Enter takes the first. Rows note themselves as ID/NAME. @param near  -1: the tree's order
/// @param chosen  marked, or -1  @param drawOthers  choices under the search  @return the bone taken, or -1
[[nodiscard]] int boneList(PanelUi& ui, const std::string& id, int near, int chosen,
                           const std::function<bool(int)>& isOffered, const std::function<void()>& drawOthers = {});

}  // namespace sinew::app
