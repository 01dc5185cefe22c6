// app/panels/flex.cpp: the slider that flexes all muscles on lines.

#include <imgui.h>

#include <algorithm>
#include <string>

#include "app/panels/overlay.h"
#include "app/ui/number_field.h"

namespace sinew::app {
namespace {

Possible withLines(const EditorState& state) {
  return withCharacter(state).also(!state.document.rig().lines.empty(), "No muscle rides a line");
}

const Control kFlexSlider{"view/flex-slider", "How hard muscles flex in the picture", "contract preview tension",
                          withLines};

constexpr float kFlexWidth = 250.0f;  // Design pixels, as all here.
constexpr float kNarrow = 200.0f;     // Below, the word goes into the slider and the button away.
constexpr float kNarrowest = 100.0f;

/// While the key is down, and from the menu until it is chosen again.
void holdFlex(PanelUi& ui, FlexState& flex) {
  const bool held = keyHeld(ui, action("view/flex"));
  if (held) flex.byKey = flex.latched;
  if (held || !flex.byKey) return;
  flex.byKey = false;
  flex.latched = false;
}

std::string flexHint(const PanelUi& ui) {
  const std::string keys = keyText(action("view/flex"), ui.state);
  const std::string held = keys.empty() ? "" : "\nHold " + keys + ": fully flexed";
  return "Flexes muscles that have a line, to see them work. Not saved." + held;
}

void whoseButton(PanelUi& ui, FlexState& flex, float width) {
  ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
  if (ImGui::Button(flex.selectedAlone ? "Selected##flexed" : "All##flexed", {width, 0.0f}))
    flex.selectedAlone = !flex.selectedAlone;
  ui.widgets.note("view/flex-whose");
  tooltip(ui, flex.selectedAlone ? "Flexes the selected muscles alone; all where none of them has a line. Click: all."
                                 : "Flexes all muscles that have a line. Click: the selected ones alone.");
}

}  // namespace

void drawFlex(PanelUi& ui) {
  FlexState& flex = ui.state.open.flex;
  const glm::vec4& v = ui.state.frame.viewport;
  if (ui.state.document.rig().lines.empty()) flex = {};
  if (ui.state.document.rig().lines.empty()) return;
  holdFlex(ui, flex);
  // Beside the numbers if there is room, else under them.
  const float room = v.z - ui.px(kBesideTools + kFromEdges);
  const float beside = room - numbersWidth(ui);
  const bool under = beside < ui.px(kNarrowest);
  const float width = std::min(ui.px(kFlexWidth), under ? room : beside);
  if (width < ui.px(kNarrowest)) return;
  const bool narrow = width < ui.px(kNarrow);
  const float height = ImGui::GetFrameHeight() + ui.px(8);
  ImGui::SetCursorPos({ui.px(kBesideTools), ui.px(under ? 90.0f : 54.0f)});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(0.88f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(8), ui.px(4)});
  ImGui::BeginChild(
      "flex", {width, height}, true,
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_AlwaysUseWindowPadding);
  if (!narrow) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Flex");
    ImGui::SameLine();
  }
  float percent = 100.0f * flex.shown();
  const float button = ImGui::CalcTextSize("Selected").x + 2.0f * ImGui::GetStyle().FramePadding.x;
  const float whose = narrow ? 0.0f : button + ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - whose);
  const bool edited =
      numberSlider(ui, "##flex", percent, {narrow ? "Flex %.0f %%" : "%.0f %%", 0.0f, 0.0f, 100.0f, 10.0f, true});
  ui.widgets.note(kFlexSlider.id);
  if (edited) flex = {percent / 100.0f, flex.selectedAlone};
  tooltip(ui, flexHint(ui));
  if (!narrow) whoseButton(ui, flex, button);
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

}  // namespace sinew::app
