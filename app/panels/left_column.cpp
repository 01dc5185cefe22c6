// app/panels/left_column.cpp: the tabs at the left, and the history below them.
#include <string>

#include "app/editor/commands.h"
#include "app/panels/blending.h"
#include "app/panels/panels.h"

namespace sinew::app {
namespace {

const Control kMusclesTab{"outliner/tab", "Tab Muscles", "outliner bones tree list hierarchy"};
const Control kGroupsTab{"blending/tab", "Tab Groups", "blending cliques"};
const Control kLibraryTab{"library/tab", "Tab Library", "presets sets"};
const Control kShapesTab{"shapes/tab", "Tab Shapes", "morph targets blend shapes"};

constexpr float kTabGap = 13.0f;          ///< Design pixels.
constexpr double kTabHoldSeconds = 0.35;  ///< A muscle that is held over a tab this long opens it.

/// A tab; holding a dragged muscle over it opens it.
void drawTab(PanelUi& ui, const char* word, const char* id, LeftTab tab) {
  OutlinerState& outliner = ui.state.view.outliner;
  const bool active = outliner.tab == tab;
  ImGui::PushFont(ui.fonts.strong);
  const ImVec2 text = ImGui::CalcTextSize(word);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 size{text.x + ui.px(2), text.y + ui.px(7)};
  if (ImGui::InvisibleButton(id, size)) outliner.tab = tab;
  ui.widgets.note(id);
  const bool dragged = ImGui::GetDragDropPayload() != nullptr;
  const bool over = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (dragged && over) {
    ui.wakeIn(kTabHoldSeconds);
    if (ImGui::GetIO().MouseDownDuration[0] > static_cast<float>(kTabHoldSeconds)) outliner.tab = tab;
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Tint color = active || over ? palette::kText : palette::kMuted;
  list.AddText(low, color.packed(), word);
  if (active) {
    list.AddRectFilled({low.x, low.y + text.y + ui.px(4)}, {low.x + text.x, low.y + text.y + ui.px(6)},
                       palette::kAccent.packed(), ui.px(1));
  }
  ImGui::PopFont();
}

}  // namespace

void drawLeftTabs(PanelUi& ui) {
  ui.state.frame.highlighted.clear();
  if (ui.state.open.rename.appearing) ui.state.view.outliner.tab = LeftTab::kMuscles;
  drawTab(ui, "Muscles", kMusclesTab.id, LeftTab::kMuscles);
  ImGui::SameLine(0.0f, ui.px(kTabGap));
  drawTab(ui, "Groups", kGroupsTab.id, LeftTab::kGroups);
  ImGui::SameLine(0.0f, ui.px(kTabGap));
  drawTab(ui, "Library", kLibraryTab.id, LeftTab::kLibrary);
  ImGui::SameLine(0.0f, ui.px(kTabGap));
  drawTab(ui, "Shapes", kShapesTab.id, LeftTab::kShapes);
  switch (ui.state.view.outliner.tab) {
    case LeftTab::kMuscles:
      return drawOutliner(ui);
    case LeftTab::kGroups:
      drawBlending(ui);
      break;
    case LeftTab::kLibrary:
      drawLibrary(ui);
      break;
    case LeftTab::kShapes:
      drawShapes(ui);
      break;
  }
  keepDraggedShown(ui);
}

void drawHistory(PanelUi& ui) {
  ImGui::BeginChild("history-steps");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(3)});
  const CommandStack& commands = ui.state.document.commands;
  const std::size_t position = commands.position();
  std::size_t wanted = position;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(commands.stepCount() + 1));
  while (clipper.Step()) {
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      const auto step = static_cast<std::size_t>(row);
      ImGui::PushID(row);
      ImGui::PushStyleColor(ImGuiCol_Text, step <= position ? palette::kText : palette::kMuted.faded(0.7f));
      const std::string& label = commands.label(step);
      const std::string shown = fitted(label, ImGui::GetContentRegionAvail().x);
      if (ImGui::Selectable((shown + "##step").c_str(), step == position)) wanted = step;
      ImGui::PopStyleColor();
      ImGui::PopID();
      ui.widgets.note("history/step/" + std::to_string(step));
      if (shown != label) tooltip(ui, label);
    }
  }
  if (wanted != position) {
    jumpTo(ui.state, wanted);
  } else if (ui.state.open.historyShown != position) {
    // Scrolls to a new step.
    const float row = ImGui::GetTextLineHeightWithSpacing();
    ImGui::SetScrollY(row * static_cast<float>(position) - 0.5f * ImGui::GetWindowHeight());
  }
  ui.state.open.historyShown = position;
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

}  // namespace sinew::app
