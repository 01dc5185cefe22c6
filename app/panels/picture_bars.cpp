// app/panels/picture_bars.cpp: bars over the top of the picture: the flex slider, and the driven key being set.
#include <algorithm>
#include <string>

#include "app/editor/animate.h"
#include "app/panels/overlay.h"
#include "app/ui/number_field.h"

namespace sinew::app {
namespace {

Possible withLines(const EditorState& state) {
  return withCharacter(state).also(!state.document.rig().lines.empty(), "No muscle rides a line");
}

const Control kFlexSlider{"view/flex-slider", "How hard muscles flex in the picture", "contract preview tension",
                          withLines};

const Control kFlexWhose{"view/flex-whose", "Flex all muscles or the selected", "preview", withLines};

constexpr float kFlexWidth = 250.0f;  // Design pixels, as all here.
constexpr float kNarrow = 200.0f;     // Below this the word is in the slider, and the button is hidden.
constexpr float kNarrowest = 100.0f;

/// Flexes while the key is held, or from one choice in the menu to the next.
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
  ui.widgets.note(kFlexWhose.id);
  tooltip(ui, flex.selectedAlone ? "Flexes only the selected muscles, or all if none of them has a line. Click: all."
                                 : "Flexes all muscles that have a line. Click: only the selected ones.");
}

}  // namespace

void drawFlex(PanelUi& ui) {
  FlexState& flex = ui.state.open.flex;
  const glm::vec4& v = ui.state.frame.viewport;
  if (ui.state.document.rig().lines.empty()) flex = {};
  if (ui.state.document.rig().lines.empty()) return;
  holdFlex(ui, flex);
  // Beside the numbers if there is room, else below them.
  const float room = v.z - ui.px(kBesideTools + kFromEdges);
  const float beside = room - numbersWidth(ui);
  const bool under = beside < ui.px(kNarrowest);
  const float width = std::min(ui.px(kFlexWidth), under ? room : beside);
  if (width < ui.px(kNarrowest)) return;
  const bool narrow = width < ui.px(kNarrow);
  const float height = ImGui::GetFrameHeight() + ui.px(8);
  beginInPicture(ui, "flex", {ui.px(kBesideTools), ui.px(under ? 90.0f : 54.0f)}, {width, height}, 0.88f, {8, 4},
                 ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (!narrow) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Flex");
    ImGui::SameLine();
  }
  float percent = 100.0f * flex.shown();
  const float button = buttonWidth("Selected");
  const float whose = narrow ? 0.0f : button + ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - whose);
  const bool edited =
      numberSlider(ui, "##flex", percent, {narrow ? "Flex %.0f %%" : "%.0f %%", 0.0f, 0.0f, 100.0f, 10.0f, true});
  ui.widgets.note(kFlexSlider.id);
  if (edited) flex = {percent / 100.0f, flex.selectedAlone};
  tooltip(ui, flexHint(ui));
  if (!narrow) whoseButton(ui, flex, button);
  endInPicture();
}

// Shown while driven keys are set: the numbers, their input and its current value.

namespace {

constexpr float kDrivenKeyTop = 54.0f;  // Design pixels, as all here: below the display bar.
constexpr float kBelowFlex = 42.0f;
constexpr float kNumbers = 186.0f;  // The numbers at the right, with their margin.

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
  // Room for the longest text, so that nothing moves while the joint turns.
  const float reading = ImGui::CalcTextSize("-180.0\xc2\xb0").x;
  const float fixed = reading + buttonWidth(set.c_str()) + buttonWidth("Done") + 3.0f * gap + ui.px(20);
  const glm::vec4& v = ui.state.frame.viewport;
  const float left = ui.px(kBesideTools);
  const float top = ui.px(kDrivenKeyTop + (ui.state.document.rig().lines.empty() ? 0.0f : kBelowFlex));
  const float room = v.z - left - ui.px(kNumbers) - fixed;
  const std::string shown = fitted(text, std::max(room, ui.px(40)));
  const float width = fixed + ImGui::CalcTextSize(shown.c_str()).x;
  ImGui::PushStyleColor(ImGuiCol_Border, palette::kDriven);
  beginInPicture(ui, "driven-key", {left, top}, {width, ImGui::GetFrameHeight() + ui.px(8)}, 0.92f, {8, 4},
                 ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
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
  const bool wanted =
      textButton(ui, "driven-key/set", set.c_str(), {}, "Sets a key: at the current input, the current " + numberWords);
  ImGui::SameLine();
  const bool done = textButton(ui, "driven-key/done", "Done", {}, "Leave the driver as it is (Esc)");
  endInPicture();
  ImGui::PopStyleColor();
  if (wanted) keyPointed(ui.state);
  if (done) endDrivenKey(ui.state);
}

}  // namespace sinew::app
