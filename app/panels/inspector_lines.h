// app/panels/inspector_lines.h: the inspector's rows about the lines of the selected muscles.
#pragma once

#include "app/editor/line_commands.h"
#include "app/panels/inspector.h"

namespace sinew::app {

/// What one does to them: ends, length, buttons.
void drawLineRows(PanelUi& ui, const Subjects& subjects);
void drawFlexRow(PanelUi& ui, const SelectedLines& lines);
/// The rest of their numbers.
void drawLineNumbers(PanelUi& ui);
/// For muscles that ride one bone.
void drawOtherEndRow(PanelUi& ui, const Subjects& subjects);

}  // namespace sinew::app
