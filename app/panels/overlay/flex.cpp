// app/panels/overlay/flex.cpp: the slider that flexes all muscles on lines.

#include <imgui.h>

#include <string>

#include "app/panels/overlay/overlay.h"
#include "app/ui/number_field.h"

namespace sinew::app {
namespace {

constexpr float kWidth = 250.0f;  // Design pixels, as all here.
constexpr float kLeft = 62.0f;    // Beside the tools.

/// While the key is down, and from the menu until it is chosen again.
void holdFlex(PanelUi& ui, FlexState& flex) {
  const bool held = keyHeld(ui, action("view/flex"));
  if (held) flex.byKey = flex.latched;
  if (held || !flex.byKey) return;
  flex.byKey = false;
  flex.latched = false;
}

}  // namespace

void drawFlex(PanelUi& ui) {
  FlexState& flex = ui.state.open.flex;
  const glm::vec4& v = ui.state.frame.viewport;
  if (ui.state.document.rig().lines.empty()) flex = {};
  if (ui.state.document.rig().lines.empty() || v.z < ui.px(kLeft + kWidth + 12.0f)) return;
  holdFlex(ui, flex);
  const float height = ImGui::GetFrameHeight() + ui.px(8);
  ImGui::SetCursorPos({ui.px(kLeft), ui.px(54)});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(0.88f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(8), ui.px(4)});
  ImGui::BeginChild(
      "flex", {ui.px(kWidth), height}, true,
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Flex");
  ImGui::SameLine();
  float percent = 100.0f * flex.shown();
  const char* whose = flex.selectedAlone ? "Selected" : "All";
  const float button = ImGui::CalcTextSize("Selected").x + 2.0f * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemInnerSpacing.x);
  const bool edited = numberSlider(ui, "##flex", percent, {"%.0f %%", 0.0f, 0.0f, 100.0f, 10.0f, true});
  ui.widgets.note("view/flex-slider");
  if (edited) flex = {percent / 100.0f, flex.selectedAlone};
  tooltip(ui, "Flexes muscles that have a line, to see them work. Not saved. " + hintOf(ui, action("view/flex")));
  ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
  if (ImGui::Button((std::string(whose) + "##flexed").c_str(), {button, 0.0f}))
    flex.selectedAlone = !flex.selectedAlone;
  ui.widgets.note("view/flex-whose");
  tooltip(ui, flex.selectedAlone ? "Flexes the selected muscles alone; all where none of them has a line. Click: all."
                                 : "Flexes all muscles that have a line. Click: the selected ones alone.");
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

}  // namespace sinew::app
