// app/panels/overlay.h: what is drawn over the picture.
#pragma once

#include <imgui.h>

#include "app/panels/panel_ui.h"

namespace sinew::app {

void drawToolStrip(PanelUi& ui);
void drawDisplayBar(PanelUi& ui);
void drawNumbers(PanelUi& ui);
[[nodiscard]] float numbersWidth(const PanelUi& ui);  ///< Width at the picture's upper right; 0 if not shown.
void drawLegend(PanelUi& ui);
void drawFlex(PanelUi& ui);
void drawDrivenKey(PanelUi& ui);
void drawCheckList(PanelUi& ui);
void drawBodyParts(PanelUi& ui);
void drawClipList(PanelUi& ui);
void drawMuscleSet(PanelUi& ui);
void drawFitSculpt(PanelUi& ui);
void drawReference(PanelUi& ui);
void drawFirstSteps(PanelUi& ui);
void drawViewportMenu(PanelUi& ui);
void drawMessages(PanelUi& ui);
[[nodiscard]] float messagesHeight(PanelUi& ui);  ///< Height of the list at the picture's lower left; 0 if not shown.

/// Design pixels: distance from the left edge, beside the tools; room for the axes at the right; other margins.
inline constexpr float kBesideTools = 62.0f;
inline constexpr float kBesideAxes = 110.0f;
inline constexpr float kFromEdges = 12.0f;
/// Width beside the tools, and beside the axes unless that leaves too little room. @param wanted  design pixels
[[nodiscard]] float widthInPicture(const PanelUi& ui, float wanted);
[[nodiscard]] float lowestInPicture(PanelUi& ui);  ///< The lowest y, above the messages.
/// Begins a child window with the frame of such a panel. @param padding  design pixels
void beginInPicture(PanelUi& ui, const char* name, const ImVec2& at, const ImVec2& size, float opacity,
                    const ImVec2& padding, ImGuiWindowFlags flags = 0);
void endInPicture();
/// A horizontal bar of colors. @param color  from 0 at the left to 1 at the right
void drawRamp(const ImVec2& low, float width, float bottom, int steps, ImU32 (*color)(float));

void drawToast(PanelUi& ui);
/// The number of messages, at the line's right end; a click shows or hides them. @return its width, 0 without messages
float drawMessageBadge(PanelUi& ui);

/// The legend of View > Export error: scale, shown mesh, a button that goes to the largest error.
void drawExportError(PanelUi& ui, const ImVec2& low);
[[nodiscard]] ImVec2 exportErrorSize(PanelUi& ui);

/// The background export in the status line: file, progress, cancel; afterwards the largest error of the last export,
/// which a click shows. Width 0 without either.
[[nodiscard]] float exportStatusWidth(PanelUi& ui);
void drawExportStatus(PanelUi& ui);  ///< At the cursor.

/// Height of the legend and the line of the mode, from the bottom of the picture; window coordinates.
[[nodiscard]] float legendHeight(PanelUi& ui);
/// Held with the mouse or by its key: shows the character without muscles. Call once a frame, for the key as well.
void drawBeforeButton(PanelUi& ui, float size);
void holdBefore(PanelUi& ui, bool held);  ///< The same where there is no room for the button. @param held  by the mouse
void drawTerritoryButton(PanelUi& ui, float size);

}  // namespace sinew::app
