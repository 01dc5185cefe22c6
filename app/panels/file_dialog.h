// app/panels/file_dialog.h: the path dialog: what is in a folder, what becomes of a path.
#pragma once

#include "app/panels/panel_ui.h"

namespace sinew::app {

/// What the list shows, by the user's preferences and the dialog's filter.
[[nodiscard]] ListingOptions listingOptions(const EditorState& state);

/// Goes there; the folder before can be gone back to.
void enterFolder(FileDialogState& dialog, const std::filesystem::path& folder);
void goBack(FileDialogState& dialog);
void goForward(FileDialogState& dialog);
void goUp(FileDialogState& dialog);

/// Opens, saves or enters what the path field says; asks before it overwrites.
void confirmPath(EditorState& state);

/// Places at the left, the folder's files at the right, `height` tall in window coordinates.
void drawFolderBrowser(PanelUi& ui, float height);

}  // namespace sinew::app
