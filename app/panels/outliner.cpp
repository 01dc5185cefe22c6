// app/panels/outliner.cpp: bones as a tree with their muscles under them; tabs that share its place with the groups.

#include <imgui.h>
#include <imgui_stdlib.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <string>

#include "app/panels/commands.h"
#include "app/panels/outliner_edit.h"
#include "app/panels/outliner_row.h"
#include "app/panels/panel_glyphs.h"
#include "app/panels/panels.h"
#include "app/panels/territory.h"
#include "app/panels/visibility_commands.h"

namespace sinew::app {
namespace {

constexpr double kTabHoldSeconds = 0.35;  ///< A muscle dragged onto a tab for so long opens it.

OutlinerFrame gather(const EditorState& state) {
  const Skeleton& skeleton = state.character().skeleton;
  OutlinerFrame frame{state.document.commands.sharedRig(), skeleton, {}, {}, {}, {}, 0.0f};
  frame.boneOf = boneOfEach(*frame.rig, skeleton);
  frame.effective = effectiveVisibility(state.document.visibility, *frame.rig, skeleton, frame.boneOf);
  if (editsTerritory(state)) {
    frame.territory.assign(skeleton.bones.size(), false);
    for (const int bone : shownTerritory(state)) frame.territory[static_cast<std::size_t>(bone)] = true;
  }
  const OutlinerState& outliner = state.panels.outliner;
  frame.rows = outlinerRows(*frame.rig, skeleton, frame.boneOf,
                            {state.outlinerFilter, outliner.onlyWithMuscles, &outliner.folded,
                             outliner.unattachedFolded});
  return frame;
}

void drawSearch(Ui& ui) {
  const float button = ImGui::GetFrameHeight();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ui.px(4));
  ImGui::InputTextWithHint("##search", "Search muscles and bones", &ui.state.outlinerFilter);
  ui.widgets.note("outliner/search");
  ImGui::SameLine(0.0f, ui.px(4));
  bool& only = ui.state.panels.outliner.onlyWithMuscles;
  if (glyphButton(ui, "outliner/only-with-muscles", Glyph::kFilter, only, button,
                  "Only bones with muscles on them or below")) {
    only = !only;
  }
}

/// Scrolls once to a muscle that has just become the active one.
void reveal(Ui& ui, const OutlinerFrame& frame) {
  EditorState& state = ui.state;
  const std::string& active = state.document.selection.active();
  const int index = findPrimitive(*frame.rig, active);
  if (active == state.revealed || index < 0) return;
  const auto found = std::ranges::find_if(frame.rows, [&](const OutlinerRow& row) {
    return row.kind == RowKind::kMuscle && row.index == index;
  });
  if (found == frame.rows.end()) {
    const int bone = frame.boneOf[static_cast<std::size_t>(index)];
    if (bone < 0) state.panels.outliner.unattachedFolded = false;
    unfoldTo(state, bone);
    // Found with the next frame, unless the search leaves it out.
    if (!state.outlinerFilter.empty()) state.revealed = active;
    return;
  }
  state.revealed = active;
  const float top = static_cast<float>(found - frame.rows.begin()) * frame.rowHeight;
  const float height = ImGui::GetWindowHeight();
  if (top < ImGui::GetScrollY() || top + frame.rowHeight > ImGui::GetScrollY() + height) {
    ImGui::SetScrollY(std::max(0.0f, top - 0.4f * height));
  }
}

void keyboard(Ui& ui, const OutlinerFrame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsWindowFocused() || io.WantTextInput || io.KeyCtrl || io.KeyAlt || frame.rows.empty()) return;
  if (ImGui::IsKeyPressed(GLFW_KEY_DOWN)) moveCursor(ui.state, frame.rows, 1, io.KeyShift);
  if (ImGui::IsKeyPressed(GLFW_KEY_UP)) moveCursor(ui.state, frame.rows, -1, io.KeyShift);
}

void drawRows(Ui& ui) {
  OutlinerFrame frame = gather(ui.state);
  frame.rowHeight = ImGui::GetTextLineHeight() + ui.px(6);
  reveal(ui, frame);
  keyboard(ui, frame);
  if (frame.rows.empty()) {
    ImGui::Dummy({0.0f, ui.px(6)});
    ImGui::PushTextWrapPos(0.0f);
    mutedText(ui.state.outlinerFilter.empty() ? "No muscles yet. Press M and drag on the skin."
                                              : "Nothing of that name.");
    ImGui::PopTextWrapPos();
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(frame.rows.size()), frame.rowHeight);
  while (clipper.Step()) {
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) drawOutlinerRow(ui, frame, row);
  }
}

/// What is put away, and the way back.
void drawFooter(Ui& ui, const std::string& text) {
  ImGui::Separator();
  ImGui::AlignTextToFramePadding();
  const float button = ImGui::CalcTextSize("Show all").x + 2.0f * ImGui::GetStyle().FramePadding.x;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x - button - ui.px(6);
  clippedText(*ImGui::GetWindowDrawList(), {at.x, at.y + ImGui::GetStyle().FramePadding.y}, room,
              palette::kMuted.packed(), text);
  ImGui::SetCursorScreenPos({at.x + room + ui.px(6), at.y});
  if (ImGui::Button("Show all")) showAll(ui.state);
  ui.widgets.note("outliner/show-all");
}

/// A word as a tab; a muscle that is dragged over it opens it.
void drawTab(Ui& ui, const char* word, const char* id, LeftTab tab) {
  OutlinerState& outliner = ui.state.panels.outliner;
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
    ui.state.wakeAfter = kTabHoldSeconds;
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

void drawLeftTabs(Ui& ui) {
  ui.state.panels.highlighted.clear();
  if (ui.state.rename.appearing) ui.state.panels.outliner.tab = LeftTab::kMuscles;
  drawTab(ui, "Muscles", "outliner/tab", LeftTab::kMuscles);
  ImGui::SameLine(0.0f, ui.px(16));
  drawTab(ui, "Groups", "blending/tab", LeftTab::kGroups);
  if (ui.state.panels.outliner.tab == LeftTab::kMuscles) {
    drawOutliner(ui);
  } else {
    drawBlending(ui);
    keepDraggedShown(ui);
  }
}

void drawOutliner(Ui& ui) {
  drawSearch(ui);
  const std::string away = anythingHidden(ui.state) ? hiddenText(ui.state) : "";
  const bool footer = anythingHidden(ui.state);
  const float below = footer ? ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y : 0.0f;
  ImGui::BeginChild("outliner-tree", {0.0f, -below});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
  drawRows(ui);
  ImGui::PopStyleVar();
  ImGui::EndChild();
  if (footer) drawFooter(ui, away.empty() ? "Some bones are switched off" : away);
}

}  // namespace sinew::app
