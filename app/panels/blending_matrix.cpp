// app/panels/blending_matrix.cpp: the blending matrix: a row for each group, and cells that link two groups, wholly or
// in part.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui_internal.h>  // ClearActiveID, which 1.86 keeps to itself.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/editor/blending_edit.h"
#include "app/panels/blending.h"
#include "app/panels/field_edit.h"
#include "app/ui/code_points.h"
#include "app/ui/reading_order.h"
#include "core/geometry/at.h"
#include "core/rig/rig_edit.h"

namespace sinew::app {
namespace {

constexpr float kLargestCell = 26.0f;  // Design pixels.
constexpr float kSmallestCell = 15.0f;
constexpr float kWholeDrag = 120.0f;  ///< Drags a link from 0 to 1.
constexpr float kDragStep = 0.1f;     ///< With Ctrl.

/// The matrix while it is drawn. Row i has the cells 0..i; the last, on the diagonal, is the group itself.
struct Matrix {
  PanelUi& ui;
  std::shared_ptr<const Rig> rig;
  std::vector<std::vector<float>> amounts;  ///< linkTable()
  std::vector<int> members;                 ///< [groups]
  ImVec2 names;                             ///< Corner of the names; scrolls vertically.
  ImVec2 cells;                             ///< Corner of cell (0, 0); scrolls in both directions.
  float nameWidth = 0.0f;
  float cell = 0.0f;
  ImVec4 clip;   ///< The visible part of the cells: left, top, right, bottom.
  int row = -1;  ///< Hovered.
  int column = -1;

  [[nodiscard]] int count() const { return static_cast<int>(rig->groups.size()); }
  [[nodiscard]] const std::string& name(int group) const { return at(rig->groups, group).name; }
  [[nodiscard]] GroupId id(int group) const { return at(rig->groups, group).id(); }
  [[nodiscard]] ImVec2 corner(int i, int j) const {
    return {cells.x + cell * static_cast<float>(j), cells.y + cell * static_cast<float>(i)};
  }
  [[nodiscard]] bool concerns(int group) const { return group == row || group == column; }
};

Tint between(const Tint& a, const Tint& b) { return {0.5f * (a.r + b.r), 0.5f * (a.g + b.g), 0.5f * (a.b + b.b)}; }

Matrix lay(PanelUi& ui) {
  Matrix matrix{ui, ui.state.document.commands.sharedRig(), {}, {}, {}, {}, 0.0f, 0.0f, {}, -1, -1};
  matrix.amounts = linkTable(*matrix.rig);
  for (const Group& group : matrix.rig->groups) {
    matrix.members.push_back(static_cast<int>(membersOf(*matrix.rig, group.name).size()));
  }
  const float room = ImGui::GetContentRegionAvail().x;
  float widest = 0.0f;
  for (int group = 0; group < matrix.count(); ++group) {
    const std::string shown = inReadingOrder(shownGroupName(*matrix.rig, group));
    widest = std::max(widest, ImGui::CalcTextSize(shown.c_str()).x);
  }
  matrix.nameWidth = std::clamp(widest + ui.px(14), ui.px(60), 0.45f * room);
  const auto count = static_cast<float>(matrix.count());
  const float fitting = std::floor((room - matrix.nameWidth) / count);
  matrix.cell = std::clamp(fitting, ui.px(kSmallestCell), ui.px(kLargestCell));
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const ImVec2 window = ImGui::GetWindowPos();
  matrix.names = {window.x, start.y};
  matrix.cells = {start.x + matrix.nameWidth, start.y};
  const ImVec2 low = ImGui::GetWindowDrawList()->GetClipRectMin();
  const ImVec2 high = ImGui::GetWindowDrawList()->GetClipRectMax();
  matrix.clip = {std::max(low.x, window.x + matrix.nameWidth), low.y, high.x, high.y};
  return matrix;
}

void choose(Matrix& matrix, int group) { matrix.ui.state.open.blending.group = matrix.id(group); }

/// Items of the names; before those of the cells, which scroll under them.
void nameItems(Matrix& matrix) {
  PanelUi& ui = matrix.ui;
  for (int group = 0; group < matrix.count(); ++group) {
    const ImVec2 at{matrix.names.x, matrix.names.y + matrix.cell * static_cast<float>(group)};
    if (at.y + matrix.cell < matrix.clip.y || at.y > matrix.clip.w) continue;
    ImGui::PushID(group);
    ImGui::SetCursorScreenPos(at);
    if (ui.state.open.blending.rename.group == matrix.id(group)) {
      groupRenameField(ui, std::max(matrix.nameWidth, ui.px(110)));
    } else {
      if (ImGui::InvisibleButton("name", {matrix.nameWidth, matrix.cell})) choose(matrix, group);
      if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem)) matrix.row = matrix.column = group;
      ui.widgets.note("blending/group/" + matrix.name(group));
      tooltip(ui, groupText(*matrix.rig, group) + "\nDouble-click renames; drop muscles here.");
      if (ImGui::BeginDragDropTarget()) {
        takeDroppedMuscles(ui, matrix.name(group));
        ImGui::EndDragDropTarget();
      }
      if (ImGui::BeginPopupContextItem("menu")) {
        groupMenu(ui, group);
        ImGui::EndPopup();
      } else if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
        startGroupRename(ui.state, matrix.id(group));
      }
    }
    ImGui::PopID();
  }
}

std::string cellHint(Matrix& matrix, int i, int j) {
  if (i == j) return groupText(*matrix.rig, i) + ", which always blend with each other";
  return lookOf(matrix.ui, fieldOfLink(*matrix.rig, i, j)).words +
         linkText(matrix.name(j), matrix.name(i), at(at(matrix.amounts, i), j)) +
         "\nDrag sideways to set how much. Right click: type, key, drive.";
}

std::string cellId(const Matrix& matrix, int i, int j) {
  return "blending/cell/" + matrix.name(i) + "/" + matrix.name(j);
}

/// Drags the amount of the link sideways, and toggles it by a click: one undo step.
void linkCell(Matrix& matrix, int i, int j, bool pressed) {
  PanelUi& ui = matrix.ui;
  const CommandStack& commands = ui.state.document.commands;
  ImGuiStorage& memory = *ImGui::GetStateStorage();
  const ImGuiID dragged = ImGui::GetID("dragged");
  notePointed(ui, fieldOfLink(*matrix.rig, i, j));
  beginFieldEdit(ui, cellId(matrix, i, j), "Link");
  if (ImGui::IsItemActivated()) memory.SetBool(dragged, false);
  if (ImGui::IsItemActive() && ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false)) {
    ImGui::ClearActiveID();  // The button is still down.
    return endFieldEdit(ui);
  }
  if (ImGui::IsItemActive() && (memory.GetBool(dragged) || ImGui::IsMouseDragging(0, ui.px(3)))) {
    memory.SetBool(dragged, true);
    const float way = ImGui::GetMouseDragDelta(0, 0.0f).x / ui.px(kWholeDrag);
    const float from = linkAmount(commands.rigOfStep(), matrix.name(i), matrix.name(j));
    const float step = ImGui::GetIO().KeyCtrl ? kDragStep : 0.0f;
    setLinkAmount(ui.state, i, j, toStep(from + way, step, 0.0f, 1.0f));
    tooltipWhile(ui, true, percentText(linkAmount(commands.rig(), matrix.name(i), matrix.name(j))));
  }
  if (pressed && !memory.GetBool(dragged)) toggleLink(ui.state, i, j);
  if (ImGui::IsItemDeactivated())
    endFieldEdit(ui, linkLabel(*matrix.rig, i, j, linkAmount(commands.rig(), matrix.name(i), matrix.name(j))));
  if (ImGui::BeginPopupContextItem("amount")) {
    linkMenu(ui, i, j);
    ImGui::EndPopup();
  }
}

void cellItem(Matrix& matrix, int i, int j) {
  ImGui::SetCursorScreenPos(matrix.corner(i, j));
  ImGui::PushID(i);
  ImGui::PushID(j);
  const bool pressed = ImGui::InvisibleButton("cell", {matrix.cell, matrix.cell});
  if (ImGui::IsItemHovered() || (i != j && ImGui::IsItemActive())) {
    matrix.row = i;
    matrix.column = j;
    if (!ImGui::IsItemActive()) tooltip(matrix.ui, cellHint(matrix, i, j));
    if (i == j && ImGui::IsMouseDoubleClicked(0)) startGroupRename(matrix.ui.state, matrix.id(i));
  }
  if (i != j) {
    linkCell(matrix, i, j, pressed);
  } else {
    matrix.ui.widgets.note(cellId(matrix, i, i));
    if (pressed) choose(matrix, i);
  }
  ImGui::PopID();
  ImGui::PopID();
}

/// Items of the cells, clipped beside the names.
void cellItems(Matrix& matrix) {
  ImGui::PushClipRect({matrix.clip.x, matrix.clip.y}, {matrix.clip.z, matrix.clip.w}, true);
  for (int i = 0; i < matrix.count(); ++i) {
    for (int j = 0; j <= i; ++j) cellItem(matrix, i, j);
  }
  ImGui::PopClipRect();
}

/// A number in the middle of a cell, if there is room. Smaller digits would lose strokes.
void drawNumber(ImDrawList& list, int number, const Tint& tint, const ImVec2& low, const ImVec2& high) {
  const std::string text = std::to_string(number);
  const float size = std::min(0.62f * (high.y - low.y), ImGui::GetFontSize());
  const ImVec2 extent = ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, 0.0f, text.c_str());
  if (extent.x > high.x - low.x) return;
  list.AddText(ImGui::GetFont(), size, {0.5f * (low.x + high.x - extent.x), 0.5f * (low.y + high.y - extent.y)},
               tint.packed(), text.c_str());
}

void drawDiagonal(const Matrix& matrix, ImDrawList& list, int group, const ImVec2& low, const ImVec2& high) {
  list.AddRectFilled(low, high, groupTint(*matrix.rig, group).packed(), matrix.ui.px(4));
  drawNumber(list, at(matrix.members, group), palette::kBackground, low, high);
}

/// Filled as far as the groups blend: with a dot where they add up, else with the percents if there is room.
void drawLink(const Matrix& matrix, ImDrawList& list, const Tint& tint, float amount, const ImVec2& low,
              const ImVec2& high) {
  const ImVec2 middle{0.5f * (low.x + high.x), 0.5f * (low.y + high.y)};
  list.AddRectFilled(low, {low.x + amount * (high.x - low.x), high.y}, tint.faded(0.42f).packed(), matrix.ui.px(4),
                     amount < 1.0f ? ImDrawFlags_RoundCornersLeft : ImDrawFlags_RoundCornersAll);
  if (amount == 1.0f) return list.AddCircleFilled(middle, 0.2f * matrix.cell, tint.packed(), 14);
  drawNumber(list, static_cast<int>(std::lround(100.0f * amount)), palette::kText, low, high);
}

void drawCell(Matrix& matrix, ImDrawList& list, int i, int j) {
  const ImVec2 corner = matrix.corner(i, j);
  if (corner.x + matrix.cell < matrix.clip.x || corner.x > matrix.clip.z) return;
  const float inset = std::max(0.05f * matrix.cell, 1.0f);
  const ImVec2 low{corner.x + inset, corner.y + inset};
  const ImVec2 high{corner.x + matrix.cell - inset, corner.y + matrix.cell - inset};
  if (i == j) {
    drawDiagonal(matrix, list, i, low, high);
  } else {
    const float amount = at(at(matrix.amounts, i), j);
    const bool across = i == matrix.row || j == matrix.column;
    if (amount < 1.0f)
      list.AddRectFilled(low, high, (across ? palette::kLine : palette::kBackground).packed(), matrix.ui.px(4));
    const Tint mixed = between(groupTint(*matrix.rig, i), groupTint(*matrix.rig, j));
    if (amount > 0.0f) drawLink(matrix, list, mixed, amount, low, high);
    if (const Link* link = animatedLink(*matrix.rig, i, j)) {
      list.AddRect(low, high, animationTint(*link).packed(), matrix.ui.px(4), 0, matrix.ui.px(1));
    }
  }
  if (i == matrix.row && j == matrix.column) {
    list.AddRect(low, high, palette::kText.packed(), matrix.ui.px(4), 0, matrix.ui.px(1.5f));
  }
}

void drawCells(Matrix& matrix) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect({matrix.clip.x, matrix.clip.y}, {matrix.clip.z, matrix.clip.w}, true);
  for (int i = 0; i < matrix.count(); ++i) {
    const float y = matrix.corner(i, 0).y;
    if (y + matrix.cell < matrix.clip.y || y > matrix.clip.w) continue;
    for (int j = 0; j <= i; ++j) drawCell(matrix, list, i, j);
  }
  list.PopClipRect();
}

void drawNames(Matrix& matrix) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const BlendingState& blending = matrix.ui.state.open.blending;
  for (int group = 0; group < matrix.count(); ++group) {
    if (blending.rename.group == matrix.id(group)) continue;
    const ImVec2 low{matrix.names.x, matrix.names.y + matrix.cell * static_cast<float>(group)};
    if (blending.group == matrix.id(group)) {
      list.AddRectFilled(low, {low.x + matrix.nameWidth - matrix.ui.px(4), low.y + matrix.cell},
                         palette::kAccent.faded(0.22f).packed(), matrix.ui.px(4));
    }
    const float y = low.y + 0.5f * (matrix.cell - ImGui::GetTextLineHeight());
    const Tint color = matrix.concerns(group) || matrix.row < 0 ? palette::kText : palette::kMuted;
    clippedText(list, {low.x + matrix.ui.px(4), y}, matrix.nameWidth - matrix.ui.px(10), color.packed(),
                shownGroupName(*matrix.rig, group));
  }
}

}  // namespace

void drawBlendingMatrix(PanelUi& ui, float height) {
  ImGui::BeginChild("blending-matrix", {0.0f, height}, false, ImGuiWindowFlags_HorizontalScrollbar);
  Matrix matrix = lay(ui);
  nameItems(matrix);
  cellItems(matrix);
  drawCells(matrix);
  drawNames(matrix);
  if (matrix.row >= 0) highlightGroup(ui.state, matrix.name(matrix.row));
  if (matrix.column >= 0 && matrix.column != matrix.row) highlightGroup(ui.state, matrix.name(matrix.column));
  ImGui::EndChild();
}

}  // namespace sinew::app
