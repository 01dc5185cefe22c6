// app/panels/export_rows.h: what the export dialog and the farm dialog both ask.
#pragma once

#include <initializer_list>

#include "app/panels/panel_ui.h"

namespace sinew::app {

inline constexpr float kExportLabels = 96.0f;  ///< Design pixels: the column of names.

/// Kind, mesh, depth, clips, joints, weights: those that the kind has. @param clips  false: they are not asked for
void drawExportSettings(PanelUi& ui, bool clips);
/// Name and folder of a file to write. @param id  "export/place"  @return whether Enter was pressed in its name
bool drawPlace(PanelUi& ui, const char* id, const char* label, DialogKind kind);
/// Words of which one is chosen, in the row that has been begun. @return the index that was clicked, or -1
int chooseWord(PanelUi& ui, const char* id, std::initializer_list<const char*> words, int chosen);

}  // namespace sinew::app
