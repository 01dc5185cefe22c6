// app/panels/tool_strip.cpp: the tools at the picture's left edge, and the display modes along its top.

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "app/panels/overlay.h"
#include "app/viewport/tools/viewport_tools.h"

namespace sinew::app {
namespace {

/// From left to right; "" is a line.
constexpr std::array kDisplay{"view/textured", "view/clay",     "view/classes",    "view/heat",    "",
                              "view/wire",     "view/skeleton", "view/primitives", "view/anatomy", "view/ground",
                              "view/numbers"};
constexpr std::size_t kUnderLine = 4;  ///< Number of the strip's buttons below its line.

/// "display/wire" for "view/wire".
std::string pillId(const char* actionId) {
  const std::string id = actionId;
  return "display" + id.substr(id.find('/'));
}

float pillWidth(PanelUi& ui, std::string_view actionId) {
  if (actionId.empty()) return ui.px(13);
  return ImGui::CalcTextSize(action(actionId).label).x + 2.0f * ImGui::GetStyle().FramePadding.x + ui.px(2);
}

void drawLine(PanelUi& ui) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float x = corner.x + ui.px(5);
  ImGui::GetWindowDrawList()->AddLine({x, corner.y + ui.px(4)}, {x, corner.y + ImGui::GetFrameHeight() - ui.px(4)},
                                      palette::kLine.packed());
  ImGui::SetCursorScreenPos({corner.x + ui.px(13), corner.y});
}

/// A menu item for an action whose button had no room.
void moreItem(PanelUi& ui, const std::string& id, const Action& item) {
  const bool enabled = item.enabled(ui.state);
  const bool checked = enabled && item.checked != nullptr && item.checked(ui.state);
  const std::string keys = "   " + keyText(item, ui.state);
  const bool chosen = ImGui::MenuItem(item.label, keys.c_str(), checked, enabled);
  ui.widgets.note(id);
  tooltip(ui, item.hint);
  if (chosen) run(item, ui.state);
}

struct StripButton {
  std::string id;
  std::string actionId;
  Icon icon;
};

std::vector<StripButton> stripButtons() {
  std::vector<StripButton> buttons;
  for (const Tool* const tool : tools()) {
    const std::string id = tool->id;
    buttons.push_back({"toolstrip" + id.substr(id.find('/')), id, tool->icon});
  }
  buttons.push_back({"toolstrip/box-select", "tool/box-select", Icon::kBox});
  buttons.push_back({"toolstrip/symmetry", "edit/symmetry", Icon::kSymmetry});
  buttons.push_back({"toolstrip/axes", "tool/axes", Icon::kAxes});
  buttons.push_back({"toolstrip/territory", "tool/territory", Icon::kTerritory});
  buttons.push_back({"toolstrip/before", "view/before", Icon::kBefore});
  return buttons;
}

void drawStripButton(PanelUi& ui, const StripButton& button, float size) {
  if (button.actionId == "tool/territory") {
    drawTerritoryButton(ui, size);
  } else if (button.actionId == "view/before") {
    drawBeforeButton(ui, size);
  } else {
    actionButton(ui, button.id, action(button.actionId), button.icon, size);
  }
  if (button.actionId == "tool/axes") {
    tooltip(ui, std::string("Now: ") + nameOf(ui.state.view.tools.gizmo.axes) + " axes");
  }
}

void beginBar(PanelUi& ui, const char* name, const ImVec2& at, const ImVec2& size, const ImVec2& spacing) {
  ImGui::SetCursorPos(at);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(0.88f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(4), ui.px(4)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, spacing);
  ImGui::BeginChild(
      name, size, true,
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_AlwaysUseWindowPadding);
}

void endBar() {
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
}

}  // namespace

void drawToolStrip(PanelUi& ui) {
  const std::vector<StripButton> buttons = stripButtons();
  const float size = ui.px(34);
  const float row = size + ui.px(2);
  const float line = ui.px(9);
  const float more = ui.px(26);
  const float room = ui.state.frame.viewport.w - std::max(legendHeight(ui), ui.px(10)) - ui.px(54 + 8) - line;
  const std::vector<float> rows(buttons.size(), row);
  const std::size_t shown = fittingCount(rows, room, more);
  const bool all = shown == buttons.size();
  if (room < more) holdBefore(ui, false);
  if (room < more) return;
  const float height = static_cast<float>(shown) * row + line + ui.px(8) + (all ? 0.0f : more);
  beginBar(ui, "toolstrip", {ui.px(10), ui.px(54)}, {size + ui.px(8), height}, {0.0f, ui.px(2)});
  for (std::size_t i = 0; i < shown; ++i) {
    if (i + kUnderLine == buttons.size()) {
      ImGui::Dummy({0.0f, ui.px(1)});
      ImGui::Separator();
    }
    drawStripButton(ui, buttons[i], size);
  }
  if (!all && beginMore(ui, "toolstrip/more", {size, more - ui.px(2)})) {
    for (std::size_t i = shown; i < buttons.size(); ++i) moreItem(ui, buttons[i].id, action(buttons[i].actionId));
    endMore();
  }
  if (!all) holdBefore(ui, false);
  endBar();
}

void drawDisplayBar(PanelUi& ui) {
  const float more = ui.px(28);
  const float room = ui.state.frame.viewport.z - ui.px(20 + 8);
  std::vector<float> widths;
  for (const char* id : kDisplay) widths.push_back(pillWidth(ui, id));
  const std::size_t shown = fittingCount(widths, room, more);
  const bool all = shown == widths.size();
  if (room < more) return;
  float width = ui.px(8) + (all ? 0.0f : more);
  for (std::size_t i = 0; i < shown; ++i) width += widths[i];
  beginBar(ui, "display", {ui.px(10), ui.px(10)}, {width, ImGui::GetFrameHeight() + ui.px(8)}, {ui.px(2), 0.0f});
  for (std::size_t i = 0; i < shown; ++i) {
    if (std::string_view(kDisplay[i]).empty()) {
      drawLine(ui);
      continue;
    }
    actionPill(ui, pillId(kDisplay[i]), action(kDisplay[i]));
    ImGui::SameLine();
  }
  if (!all && beginMore(ui, "display/more", {more - ui.px(2), 0.0f})) {
    for (std::size_t i = shown; i < widths.size(); ++i) {
      if (std::string_view(kDisplay[i]).empty()) ImGui::Separator();
      else moreItem(ui, pillId(kDisplay[i]), action(kDisplay[i]));
    }
    endMore();
  }
  endBar();
}

}  // namespace sinew::app
