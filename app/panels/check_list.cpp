// app/panels/check_list.cpp: what Play > Check muscles found; a click goes there.

#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "app/editor/muscle_set_commands.h"
#include "app/panels/overlay.h"
#include "app/ui/code_points.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

constexpr float kCheckListWidth = 560.0f;  // Design pixels, as all here.
constexpr int kMostRows = 6;

std::string momentText(const Finding& finding) {
  if (finding.clip.empty()) return "bind pose";
  char time[32];
  std::snprintf(time, sizeof time, " %.2f s", static_cast<double>(finding.time));
  return finding.clip + time;
}

std::string headingOf(const EditorState& state) {
  const std::size_t count = state.open.check.findings.size();
  if (!checkIsCurrent(state)) return "The rig has changed since it was checked";
  if (count == 0) return "All muscles stay in the flesh in all clips";
  return std::to_string(count) + (count == 1 ? " finding" : " findings") + ": click one to see it";
}

void drawRow(PanelUi& ui, int index) {
  EditorState& state = ui.state;
  const CheckState& check = state.open.check;
  const Finding& finding = at(check.findings, index);
  const int muscle = findPrimitive(state.document.rig(), at(check.muscles, index));
  const std::string name = muscle < 0 ? "(deleted)" : shownMuscleName(state.document.rig(), muscle);
  const std::string text = name + ": " + textOf(finding);
  const std::string when = momentText(finding);
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(when.c_str()).x - ui.px(16);
  ImGui::PushID(index);
  const bool chosen = ImGui::Selectable(fitted(text, room).c_str(), check.chosen == index,
                                        muscle < 0 ? ImGuiSelectableFlags_Disabled : ImGuiSelectableFlags_None);
  ImGui::PopID();
  ui.widgets.note("check/" + std::to_string(index));
  tooltip(ui, text + "\n" + when);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(when.c_str()).x);
  mutedText(when.c_str());
  if (chosen && muscle >= 0) goToFinding(state, index);
}

}  // namespace

void drawCheckList(PanelUi& ui) {
  EditorState& state = ui.state;
  if (!state.open.check.shown) return;
  const float width = widthInPicture(ui, kCheckListWidth);
  const auto rows = static_cast<float>(std::clamp(static_cast<int>(state.open.check.findings.size()), 0, kMostRows));
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const float height = rows * line + 2.0f * ImGui::GetFrameHeightWithSpacing() + ui.px(20);
  const float top = lowestInPicture(ui) - height;
  ImGui::SetCursorPos({ui.px(kBesideTools), std::max(top, 0.0f)});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(0.94f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(8)});
  ImGui::BeginChild("check", {width, height}, true, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::TextUnformatted(headingOf(state).c_str());
  ui.widgets.note("check/heading");
  ImGui::BeginChild("rows", {0.0f, -ImGui::GetFrameHeightWithSpacing()});
  for (int i = 0; i < static_cast<int>(state.open.check.findings.size()); ++i) drawRow(ui, i);
  ImGui::EndChild();
  const bool current = checkIsCurrent(state);
  ImGui::BeginDisabled(current && state.open.check.findings.empty());
  const bool wanted = ImGui::Button(current ? "Mend" : "Check again");
  ImGui::EndDisabled();
  ui.widgets.note("check/mend");
  tooltip(ui, current
                  ? "Change the lines of these muscles until they stay in the flesh: pivot, via point, tendons, flex"
                  : "Look through all clips again");
  ImGui::SameLine();
  const bool closed = ImGui::Button("Close");
  ui.widgets.note("check/close");
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  if (wanted) mendFindings(state);
  if (closed) closeCheck(state);
}

}  // namespace sinew::app
