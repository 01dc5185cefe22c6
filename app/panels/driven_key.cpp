// app/panels/driven_key.cpp: while driven keys are set: of which numbers, by what, and where that is now.

#include <imgui.h>

#include "app/editor/animate.h"
#include "app/panels/overlay.h"

namespace sinew::app {
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
