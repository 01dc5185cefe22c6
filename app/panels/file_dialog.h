// app/panels/file_dialog.h: the parts of the path dialog.
#pragma once

#include "app/panels/panel_ui.h"

namespace sinew::app {

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
