// app/panels/picture_bars.cpp: bars over the top of the picture: the flex slider, and the driven key being set.
#include <algorithm>
#include <string>

#include <imgui.h>

#include "app/editor/animate.h"
#include "app/editor/animated_names.h"
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

// While driven keys are set: of which numbers, by what, and where that is now.

namespace {

constexpr float kDrivenKeyTop = 54.0f;  // Design pixels, as all here: below the display bar.
constexpr float kBelowFlex = 42.0f;
constexpr float kNumbers = 186.0f;  // The numbers at the right, with their margin.

float buttonWidth(const char* label) { return ImGui::CalcTextSize(label).x + 2.0f * ImGui::GetStyle().FramePadding.x; }

}  // namespace

void drawDrivenKey(PanelUi& ui) {
  if (!ui.state.open.animate.drivenKey.isOn()) return;
  const std::vector<NumberRef> refs = drivenKeyNumbers(ui.state);
  const DriverInput input = ui.state.open.animate.drivenKey.input;
  const std::optional<float> x = inputNow(ui.state, input);
  if (refs.empty() || !x) return endDrivenKey(ui.state);
  const std::string inputWords = wordsFor(input, ui.state.character().skeleton);
  const std::string numberWords = wordsFor(ui.state.document.rig(), refs);
  const std::string text = numberWords + " by " + inputWords;
  const std::string now = inputText(input.kind, *x);
  const std::string key = keyText(action("edit/key"), ui.state);
  const std::string set = key.empty() ? "Set key" : "Set key (" + key + ")";
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  // Room for the widest reading, so that nothing moves while the joint turns.
  const float reading = ImGui::CalcTextSize("-180.0\xc2\xb0").x;
  const float fixed = reading + buttonWidth(set.c_str()) + buttonWidth("Done") + 3.0f * gap + ui.px(20);
  const glm::vec4& v = ui.state.frame.viewport;
  const float left = ui.px(kBesideTools);
  const float top = ui.px(kDrivenKeyTop + (ui.state.document.rig().lines.empty() ? 0.0f : kBelowFlex));
  const float room = v.z - left - ui.px(kNumbers) - fixed;
  const std::string shown = fitted(text, std::max(room, ui.px(40)));
  const float width = fixed + ImGui::CalcTextSize(shown.c_str()).x;
  ImGui::SetCursorPos({left, top});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(0.92f));
  ImGui::PushStyleColor(ImGuiCol_Border, palette::kDriven);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(8), ui.px(4)});
  ImGui::BeginChild(
      "driven-key", {width, ImGui::GetFrameHeight() + ui.px(8)}, true,
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(shown.c_str());
  ui.widgets.note("driven-key/text");
  tooltip(ui, text +
                  "\nPose the joint or choose another moment, set the number in its field, and so on: each is a "
                  "point of the driver's curve.");
  ImGui::SameLine();
  const float from = ImGui::GetCursorPosX();
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kDriven);
  ImGui::TextUnformatted(now.c_str());
  ImGui::PopStyleColor();
  ui.widgets.note("driven-key/now");
  tooltip(ui, "The " + inputWords + " now");
  ImGui::SameLine(from + reading + gap);
  const bool wanted = ImGui::Button(set.c_str());
  ui.widgets.note("driven-key/set");
  tooltip(ui, "The " + numberWords + " is to be here what it is now");
  ImGui::SameLine();
  const bool done = ImGui::Button("Done");
  ui.widgets.note("driven-key/done");
  tooltip(ui, "Leave the driver as it is (Esc)");
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  if (wanted) keyPointed(ui.state);
  if (done) endDrivenKey(ui.state);
}

}  // namespace sinew::app
