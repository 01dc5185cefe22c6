// app/panels/overlay/tool_strip.cpp: tools at the picture's left edge, ways of showing along its top.

#include <imgui.h>

#include <array>
#include <string>
#include <string_view>

#include "app/panels/overlay/legend.h"
#include "app/panels/overlay/overlay.h"
#include "app/tools/tool.h"

namespace sinew::app {
namespace {

constexpr std::array kShadings{"view/textured", "view/clay", "view/classes", "view/heat"};
constexpr std::array kToggles{"view/wire",      "view/skeleton", "view/primitives",
                              "view/influence", "view/ground",   "view/numbers"};

/// "display/wire" for "view/wire".
std::string pillId(const char* actionId) {
  const std::string id = actionId;
  return "display" + id.substr(id.find('/'));
}

float pillWidth(const char* actionId) {
  return ImGui::CalcTextSize(action(actionId).label).x + 2.0f * ImGui::GetStyle().FramePadding.x;
}

}  // namespace

void drawToolStrip(PanelUi& ui) {
  const float size = ui.px(34);
  const float pad = ui.px(4);
  const auto rows = static_cast<float>(kToolCount + 5);
  ImGui::SetCursorPos({ui.px(10), ui.px(54)});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(0.88f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, ui.px(2)});
  ImGui::BeginChild(
      "toolstrip", {size + 2.0f * pad, rows * (size + ui.px(2)) + ui.px(9) + 2.0f * pad}, true,
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_AlwaysUseWindowPadding);
  for (const Tool* const tool : tools()) {
    const std::string_view id = tool->id;
    actionButton(ui, "toolstrip" + std::string(id.substr(id.find('/'))), action(id), tool->icon, size);
  }
  actionButton(ui, "toolstrip/box-select", action("tool/box-select"), Icon::kBox, size);
  ImGui::Dummy({0.0f, ui.px(1)});
  ImGui::Separator();
  actionButton(ui, "toolstrip/symmetry", action("edit/symmetry"), Icon::kSymmetry, size);
  actionButton(ui, "toolstrip/axes", action("tool/axes"), Icon::kAxes, size);
  tooltip(ui, std::string("Now: ") + nameOf(ui.state.view.tools.gizmo.axes) + " axes");
  drawTerritoryButton(ui, size);
  drawBeforeButton(ui, size);
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
}

void drawDisplayBar(PanelUi& ui) {
  const float gap = ui.px(2);
  float width = 2.0f * ui.px(4) + ui.px(13);
  for (const char* id : kShadings) width += pillWidth(id) + gap;
  for (const char* id : kToggles) width += pillWidth(id) + gap;
  const float room = ui.state.frame.viewport.z - 2.0f * ui.px(10);
  ImGui::SetCursorPos({ui.px(10), ui.px(10)});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(0.88f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(4), ui.px(4)});
  ImGui::BeginChild("display", {width < room ? width : room, ImGui::GetFrameHeight() + 2.0f * ui.px(4)}, true,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_AlwaysUseWindowPadding);
  for (const char* id : kShadings) {
    actionPill(ui, pillId(id), action(id));
    ImGui::SameLine(0.0f, gap);
  }
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddLine({corner.x + ui.px(6), corner.y + ui.px(4)},
                                      {corner.x + ui.px(6), corner.y + ImGui::GetFrameHeight() - ui.px(4)},
                                      palette::kLine.packed());
  ImGui::SetCursorScreenPos({corner.x + ui.px(13), corner.y});
  for (const char* id : kToggles) {
    actionPill(ui, pillId(id), action(id));
    ImGui::SameLine(0.0f, gap);
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

}  // namespace sinew::app
