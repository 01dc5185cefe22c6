// app/panels/dialogs.h: dialogs, the parts of the path dialog, and the rows that dialogs share.
#pragma once

#include <string>

#include "app/panels/panel_ui.h"

namespace sinew::app {

void drawFileDialog(PanelUi& ui);
void drawUnsavedQuestion(PanelUi& ui);
void drawExportDialog(PanelUi& ui);
void drawFarmDialog(PanelUi& ui);
void drawPicturesDialog(PanelUi& ui);
void drawExportQuestion(PanelUi& ui);
void drawLocateQuestion(PanelUi& ui);
void drawKeepMusclesQuestion(PanelUi& ui);
void drawConflictQuestion(PanelUi& ui);
void drawRecoveryQuestion(PanelUi& ui);
void drawKeySheet(PanelUi& ui);
void drawPreferences(PanelUi& ui);
void drawKeysPage(PanelUi& ui);  ///< The second page of the preferences: every action with its keys.
/// Radio buttons; each notes itself as `id` and the keymap's name.
void drawKeymapChoice(PanelUi& ui, const std::string& id);
void drawPalette(PanelUi& ui);

// Rows that the export, farm and pictures dialogs share.
inline constexpr float kExportLabels = 96.0f;  ///< Design pixels: the column of names.
/// A slider for an integer that fills the current row. @return whether it has changed
bool countSlider(PanelUi& ui, const char* id, int& count, const char* format, int least, int most);
/// Enter presses the dialog's button, unless it ends the editing of a field. Call before drawing the fields.
[[nodiscard]] bool enterConfirms();
/// The error, or the question whether to overwrite.
void dialogComplaint(const std::string& error, const std::string& question);
/// Changes by a place row: typing clears the error and the question, the button sets `browse`.
struct PlaceChanges {
  std::string& error;
  bool& overwriteAsked;
  bool& browse;
};
/// Name and folder of a file to write. @param id  "export/place"  @return whether Enter was pressed in the name
bool placeRow(PanelUi& ui, const char* id, const char* label, ExportPlace& place, PlaceChanges changes);

// Parts of the path dialog.

/// Filter and order of the list, from the preferences and the dialog.
[[nodiscard]] ListingOptions listingOptions(const EditorState& state);

void enterFolder(FileDialogState& dialog, const std::filesystem::path& folder);  ///< goBack() leaves it.
void goBack(FileDialogState& dialog);
void goForward(FileDialogState& dialog);
void goUp(FileDialogState& dialog);

void confirmPath(EditorState& state);  ///< Opens, saves or enters the path in the field; asks before it overwrites.

/// Places at the left, the folder's files at the right. @param height  window coordinates
void drawFolderBrowser(PanelUi& ui, float height);

}  // namespace sinew::app
