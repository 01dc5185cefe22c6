// app/panels/overlay.h: what is drawn over the picture.
#pragma once

#include <imgui.h>

#include "app/panels/panel_ui.h"

namespace sinew::app {

void drawToolStrip(PanelUi& ui);
void drawDisplayBar(PanelUi& ui);
void drawNumbers(PanelUi& ui);
/// What they take of the picture's upper right; 0 while they are not shown.
[[nodiscard]] float numbersWidth(const PanelUi& ui);
void drawLegend(PanelUi& ui);
/// Only where muscles have lines.
void drawFlex(PanelUi& ui);
/// What is being set, and where its input is now.
void drawDrivenKey(PanelUi& ui);
/// What Play > Check muscles found.
void drawCheckList(PanelUi& ui);
/// Which bone is which part of the body, with a figure.
void drawBodyParts(PanelUi& ui);
/// The files whose clips were added.
void drawClipList(PanelUi& ui);
/// The sliders of the set of muscles that was added last.
void drawMuscleSet(PanelUi& ui);
/// View > Reference picture.
void drawReference(PanelUi& ui);
/// Help > First steps.
void drawFirstSteps(PanelUi& ui);
/// The context menu that a right click asks for.
void drawViewportMenu(PanelUi& ui);
void drawMessages(PanelUi& ui);
/// Height of the list at the picture's lower left; 0 while it is not shown.
[[nodiscard]] float messagesHeight(PanelUi& ui);

/// Design pixels, of panels over the picture: beside the tools, room for the axes at the right, and from its edges.
inline constexpr float kBesideTools = 62.0f;
inline constexpr float kBesideAxes = 110.0f;
inline constexpr float kFromEdges = 12.0f;
/// How wide such a panel is beside the tools: beside the axes as well unless that leaves too little to read.
/// @param wanted  design pixels
[[nodiscard]] float widthInPicture(const PanelUi& ui, float wanted);
/// How low such a panel may reach: above the messages.
[[nodiscard]] float lowestInPicture(PanelUi& ui);

void drawToast(PanelUi& ui);
/// How many messages there are, at the right end of the current line; a click shows or hides them. @return its width,
/// 0 without messages.
float drawMessageBadge(PanelUi& ui);

/// View > Export error: its scale, which mesh is shown, and the way to the largest. @param low  of the plate
void drawExportError(PanelUi& ui, const ImVec2& low);
/// Of the plate.
[[nodiscard]] ImVec2 exportErrorSize(PanelUi& ui);

/// What is exported in the background, in the status line: file, progress, cancel; afterwards the largest distance of
/// the last export, which a click shows. 0 wide while there is nothing.
[[nodiscard]] float exportStatusWidth(PanelUi& ui);
/// At the cursor.
void drawExportStatus(PanelUi& ui);

/// Height of the legend and the line of the mode, from the bottom of the picture; window coordinates.
[[nodiscard]] float legendHeight(PanelUi& ui);
/// Held with the mouse or by its key: shows the character without muscles. Call once a frame, for the key as well.
void drawBeforeButton(PanelUi& ui, float size);
/// The same where there is no room for the button. @param held  by the mouse
void holdBefore(PanelUi& ui, bool held);
void drawTerritoryButton(PanelUi& ui, float size);

}  // namespace sinew::app
