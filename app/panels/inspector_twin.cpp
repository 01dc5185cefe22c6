// app/panels/inspector_twin.cpp: the muscle on the other side, and the link to it.

#include <imgui.h>

#include <algorithm>
#include <string>

#include "app/editor/symmetry_commands.h"
#include "app/panels/inspector.h"

namespace sinew::app {
namespace {

/// A button for an action at the end of the row.
void rowButton(PanelUi& ui, const char* text, const std::string& id, const char* actionId, float width) {
  const Action& item = action(actionId);
  const bool enabled = item.enabled(ui.state);
  ImGui::BeginDisabled(!enabled);
  const float room = width - 2.0f * ImGui::GetStyle().FramePadding.x;
  const bool pressed = ImGui::Button((fitted(text, room) + "##" + id).c_str(), {width, 0.0f});
  ui.widgets.note(id);
  ImGui::EndDisabled();
  tooltip(ui, tooltipOf(ui, item));
  if (pressed && enabled) run(item, ui.state);
}

}  // namespace

void drawTwinRow(PanelUi& ui, const Subjects& subjects) {
  if (subjects.several() || (!canMirror(ui.state.document) && subjects.shown().mirror.empty())) return;
  beginRow(ui, "Twin");
  const float room = ImGui::GetContentRegionAvail().x;
  const std::string& twin = subjects.shown().mirror;
  if (twin.empty()) {
    rowButton(ui, "Mirror to other side", "inspector/mirror", "edit/mirror", room);
    return;
  }
  const float gap = ui.px(4);
  const float unlink = ImGui::CalcTextSize("Unlink").x + 2.0f * ImGui::GetStyle().FramePadding.x;
  const std::string why = whyTwinStays(ui.state.document);
  if (!why.empty()) ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
  ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0.0f, 0.5f});
  const float width = std::max(room - unlink - gap, ui.px(24));
  const std::string shown = fitted(twin, width - 2.0f * ImGui::GetStyle().FramePadding.x);
  const bool chosen = ImGui::Button((shown + "##twin").c_str(), {width, 0.0f});
  ImGui::PopStyleVar();
  if (!why.empty()) ImGui::PopStyleColor();
  ui.widgets.note("inspector/twin");
  tooltip(ui, why.empty() ? twin + "\nThe linked twin follows every edit, mirrored. Click to select it."
                          : twin + "\nThe twin stays where it is: " + why + ".");
  ImGui::SameLine(0.0f, gap);
  rowButton(ui, "Unlink", "inspector/unlink", "edit/unlink-twin", unlink);
  if (chosen) selectTwins(ui.state.document);
}

}  // namespace sinew::app
