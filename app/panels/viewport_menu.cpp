// app/panels/viewport_menu.cpp: the context menu of the picture.

#include "app/editor/commands.h"

#include <string>
#include <utility>

#include "app/document/listed_muscles.h"
#include "app/editor/blending_edit.h"
#include "app/editor/visibility_commands.h"
#include "app/panels/overlay.h"
#include "app/ui/reading_order.h"
#include "app/viewport/tools/select.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

constexpr const char* kPopup = "viewport-menu";

/// Tooltip of the last item, even if it is disabled.
void hint(PanelUi& ui, const std::string& text) {
  if (!text.empty() && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(8), ui.px(5)});
    ImGui::SetTooltip("%s", text.c_str());
    ImGui::PopStyleVar();
  }
}

/// An action with its label and key; disabled, with the reason, if it cannot run.
void viewportActionItem(PanelUi& ui, const char* id) {
  const Action& item = action(id);
  const std::string keys = "   " + keyText(item, ui.state);
  const bool enabled = item.enabled(ui.state);
  const bool chosen = ImGui::MenuItem(item.label, keys.c_str(), item.checked && item.checked(ui.state), enabled);
  ui.widgets.note(std::string("context/") + id);
  hint(ui, enabled ? "" : whyDisabled(ui.state, id));
  if (chosen) run(item, ui.state);
}

/// A dot in the group's color before a muscle's name.
void swatch(PanelUi& ui, const ImVec2& corner, const PickEntry& entry) {
  const Rig& rig = ui.state.document.rig();
  const int index = findPrimitive(rig, entry.muscle);
  if (index < 0) return;
  const Tint tint = groupTint(rig, at(rig.primitives, index).group);
  ImGui::GetWindowDrawList()->AddCircleFilled({corner.x + ui.px(7), corner.y + 0.5f * ImGui::GetTextLineHeight()},
                                              ui.px(4), tint.packed(), 16);
}

void drawTitle(PanelUi& ui, const ViewportHover& target) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  std::string text = "Nothing here";
  if (!target.here.empty()) {
    const PickEntry& entry = target.here[target.at];
    text = nameOf(entry, ui.state.document);
    if (entry.muscle) text = "     " + text;
    swatch(ui, corner, entry);
  }
  const Document& document = ui.state.document;
  const std::size_t selected = leadsOf(document.rig(), selectedIndices(document)).size();
  if (selected > 1) text += "  (" + std::to_string(selected) + " selected)";
  mutedText(text.c_str());
  ui.widgets.note("context/title");
}

/// Everything under the pointer, nearest first.
void selectSubmenu(PanelUi& ui, const ViewportHover& target) {
  if (target.here.size() < 2) return;
  const bool open = ImGui::BeginMenu("Select");
  ui.widgets.note("context/select");
  if (!open) return;
  Document& document = ui.state.document;
  for (std::size_t i = 0; i < target.here.size(); ++i) {
    const PickEntry& entry = target.here[i];
    const std::string name = nameOf(entry, document);
    if (name.empty()) continue;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool selected = entry.muscle ? document.selection.contains(entry.muscle) : false;
    ImGui::PushID(static_cast<int>(i));
    const bool chosen =
        ImGui::MenuItem(("     " + inReadingOrder(name)).c_str(), entry.concealed ? "   behind" : nullptr, selected);
    ImGui::PopID();
    ui.widgets.note("context/select/" + name);
    swatch(ui, corner, entry);
    if (chosen) selectEntry(document, entry);
  }
  ImGui::EndMenu();
}

void addHere(PanelUi& ui, const ViewportHover& target) {
  const bool possible = target.skin.has_value();
  const bool chosen = contextItem(ui, "Add muscle here", "add-here", possible);
  hint(ui, possible ? "" : "There is no skin here");
  if (chosen) addMuscleAt(ui.state, target);
}

void drawItems(PanelUi& ui, const ViewportHover& target) {
  drawTitle(ui, target);
  ImGui::Separator();
  if (target.here.empty()) {
    for (const char* id : {"edit/select-all", "edit/paste", "view/show-all", "view/frame-all"})
      viewportActionItem(ui, id);
    return;
  }
  selectSubmenu(ui, target);
  for (const char* id : {"view/frame", "view/isolate", "view/hide"}) viewportActionItem(ui, id);
  if (anythingHidden(ui.state.document)) viewportActionItem(ui, "view/show-all");
  ImGui::Separator();
  addHere(ui, target);
  if (!target.here[target.at].muscle) {
    for (const char* id : {"edit/add-on-bone", "edit/select-on-bone"}) viewportActionItem(ui, id);
  }
  const bool onSheet = activeSheet(ui.state.document) >= 0;
  for (const char* id : {"edit/duplicate", "edit/mirror", onSheet ? "edit/break-sheet" : "tool/territory"}) {
    viewportActionItem(ui, id);
  }
  ImGui::Separator();
  for (const char* id : {"edit/rename", "edit/delete"}) viewportActionItem(ui, id);
}

}  // namespace

void drawViewportMenu(PanelUi& ui) {
  ViewportMenuState& menu = ui.state.open.viewportMenu;
  if (std::exchange(menu.wanted, false)) {
    selectForMenu(ui.state.document, menu.target);
    ImGui::OpenPopup(kPopup);
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), ui.px(6)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(8)});
  if (ImGui::BeginPopup(kPopup)) {
    drawItems(ui, menu.target);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

}  // namespace sinew::app
