// app/panels/outliner_row.cpp: one row of the outliner.

#include "app/panels/outliner_row.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <string>

#include "app/document/listed_muscles.h"
#include "app/editor/blending_edit.h"
#include "app/editor/commands.h"
#include "app/editor/outliner.h"
#include "app/ui/code_points.h"
#include "app/ui/reading_order.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

constexpr float kOutlinerRowIndent = 13.0f;  // Design pixels, as all here.
constexpr float kCell = 18.0f;
constexpr float kGlyph = 14.0f;
constexpr float kNameFrom = 36.0f;  // From the row's indent: the fold mark and the icon.

struct Row {
  PanelUi& ui;
  const OutlinerContent& frame;
  const OutlinerRow& row;
  int position;
  ImVec2 low;
  ImVec2 high;
  bool hovered = false;

  [[nodiscard]] float indent() const {
    return low.x + ui.px(4.0f + kOutlinerRowIndent * static_cast<float>(row.level));
  }
  [[nodiscard]] float middle(float size) const { return low.y + 0.5f * (high.y - low.y - size); }
  [[nodiscard]] const Primitive& primitive() const { return at(frame.rig->primitives, row.index); }
  [[nodiscard]] const Bone& bone() const { return at(frame.skeleton.bones, row.index); }
  [[nodiscard]] bool isMuscle() const { return row.kind == RowKind::kMuscle; }
  /// The left edge of the visible switches.
  [[nodiscard]] float nameEnd() const {
    const Visibility& visibility = ui.state.document.visibility;
    int cells = 1;
    for (const Mark mark : {Mark::kLocked, Mark::kSolo}) {
      const Visibility::Marks& marks = visibility.marks(mark);
      const bool set = isMuscle() ? marks.muscles.contains(primitive().id()) : marks.bones.contains(bone().path);
      if (set) cells = mark == Mark::kLocked ? std::max(cells, 2) : 3;
    }
    if (hovered) cells = isMuscle() ? 3 : 4;
    return high.x - ui.px(kCell * static_cast<float>(cells) + 2.0f);
  }
  /// Last part of the controls' ids.
  [[nodiscard]] std::string name() const {
    return isMuscle() ? muscleName(*frame.rig, row.index) : frame.skeleton.fileName(row.index);
  }
};

/// A clickable square at the right end; column 0 is the rightmost. @param always  draw it even if not hovered
bool cell(Row& row, int column, const std::string& id, Icon glyph, const Tint& color, bool always,
          const std::string& hint) {
  PanelUi& ui = row.ui;
  const float size = ui.px(kCell);
  const ImVec2 at{row.high.x - size * static_cast<float>(column + 1), row.low.y};
  ImGui::SetCursorScreenPos(at);
  const bool pressed = ImGui::InvisibleButton(id.c_str(), {size, row.high.y - row.low.y});
  ui.widgets.note(id);
  tooltip(ui, hint);
  const bool over = ImGui::IsItemHovered();
  if (!always && !row.hovered && !over) return pressed;
  const float glyphSize = ui.px(kGlyph);
  drawIcon(*ImGui::GetWindowDrawList(), glyph, {at.x + 0.5f * (size - glyphSize), row.middle(glyphSize)}, glyphSize,
           (over ? palette::kText : color).packed());
  return pressed;
}

/// One of the three switches of a row; changes the row, and all selected muscles if it is one of them.
void switchCell(Row& row, int column, Mark mark, const char* word, Icon on, Icon off, const std::string& hint) {
  Visibility& visibility = row.ui.state.document.visibility;
  const bool set = row.isMuscle() ? visibility.marks(mark).muscles.contains(row.primitive().id())
                                  : visibility.marks(mark).bones.contains(row.bone().path);
  const std::string id = std::string("outliner/") + word + "/" + (row.isMuscle() ? "" : "bone/") + row.name();
  const bool eye = mark == Mark::kHidden;  // An open eye is the normal state and is drawn faint.
  const Tint color = set ? (mark == Mark::kSolo ? palette::kAccent : palette::kText) : palette::kMuted.faded(0.45f);
  if (!cell(row, column, id, set ? on : off, color, set || eye, hint)) return;
  if (!row.isMuscle()) {
    visibility.setBone(mark, row.bone().path, !set);
    return;
  }
  const Document& document = row.ui.state.document;
  visibility.setMuscle(mark, row.primitive().id(), !set);
  if (!document.selection.contains(row.primitive().id())) return;
  for (const int lead : leadsOf(document.rig(), selectedIndices(document))) {
    visibility.setMuscle(mark, document.idAt(lead), !set);
  }
}

void drawSwitches(Row& row) {
  const char* of = row.isMuscle() ? "this muscle" : "all muscles on this bone and below";
  switchCell(row, 0, Mark::kHidden, "eye", Icon::kEyeShut, Icon::kEye,
             std::string("Show or hide ") + of + ". Hidden muscles do not move the skin; they stay in the file.");
  switchCell(row, 1, Mark::kLocked, "lock", Icon::kLock, Icon::kUnlocked,
             std::string("Lock ") + of + ": no picking or moving in the picture.");
  switchCell(row, 2, Mark::kSolo, "solo", Icon::kSolo, Icon::kSolo, std::string("Solo: show ") + of + " alone.");
}

void drawFold(Row& row) {
  if (!row.row.foldable) return;
  PanelUi& ui = row.ui;
  const float size = ui.px(16);
  ImGui::SetCursorScreenPos({row.indent() - ui.px(2), row.low.y});
  const bool pressed = ImGui::InvisibleButton("fold", {size, row.high.y - row.low.y});
  const bool all = ImGui::GetIO().KeyShift;
  const bool part = row.row.kind == RowKind::kPart;
  const std::string title = part ? "part/" + row.row.part : std::string("unattached");
  ui.widgets.note("outliner/fold/" + (row.row.index < 0 ? title : row.name()));
  drawIcon(*ImGui::GetWindowDrawList(), row.row.open ? Icon::kFoldOpen : Icon::kFoldClosed,
           {row.indent() - ui.px(2), row.middle(size)}, size,
           (ImGui::IsItemHovered() ? palette::kText : palette::kMuted).packed());
  if (!pressed) return;
  if (part) {
    setPartFolded(ui.state, row.row.part, row.row.open);
  } else if (row.row.index < 0) {
    ui.state.view.outliner.unattachedFolded = row.row.open;
  } else {
    setFolded(ui.state, row.row.index, row.row.open, all);
  }
}

void drawRename(Row& row) {
  PanelUi& ui = row.ui;
  RenameState& typed = ui.state.open.rename;
  ImGui::SetCursorScreenPos({row.indent() + ui.px(kNameFrom - 8), row.low.y});
  if (typed.appearing) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(row.high.x - row.indent() - ui.px(kNameFrom - 4));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(8), ui.px(2)});
  const bool entered = ImGui::InputText("##rename", &typed.text,
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopStyleVar();
  ui.widgets.note("outliner/rename");
  const bool left = !typed.appearing && ImGui::IsItemDeactivated();
  typed.appearing = false;
  if (entered) rename(ui.state, typed.primitive, typed.text);
  if (entered || left) typed = {};
}

void drawDragged(PanelUi& ui, int index) {
  const Rig& rig = ui.state.document.rig();
  const std::size_t count = leadsOf(rig, draggedMuscles(ui.state.document, index)).size();
  const std::string name = inReadingOrder(shownMuscleName(rig, index));
  ImGui::TextUnformatted((count == 1 ? name : std::to_string(count) + " muscles").c_str());
  mutedText("Drop on a bone or a group");
}

void dragSource(Row& row) {
  if (!ImGui::BeginDragDropSource()) return;
  ImGui::SetDragDropPayload(kMusclePayload, &row.row.index, sizeof row.row.index);
  drawDragged(row.ui, row.row.index);
  ImGui::EndDragDropSource();
}

void dropTarget(Row& row) {
  if (!ImGui::BeginDragDropTarget()) return;
  if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kMusclePayload)) {
    reparentMuscles(row.ui.state, draggedMuscles(row.ui.state.document, *static_cast<const int*>(payload->Data)),
                    row.row.index);
  }
  ImGui::EndDragDropTarget();
}

/// Whether the pointer in the picture is over the row's muscle, or over its bone and no muscle.
bool isPointedAt(const Row& row) {
  const ViewportHover& hover = row.ui.state.view.tools.hover;
  if (row.isMuscle()) return hover.primitive == row.row.index;
  return row.row.kind == RowKind::kBone && hover.primitive < 0 && hover.bone == row.row.index;
}

/// The row's background: selection, hover, clicks, menu, drag and drop.
void drawBar(Row& row, bool selected) {
  PanelUi& ui = row.ui;
  if (isPointedAt(row)) {
    ImGui::GetWindowDrawList()->AddRectFilled(row.low, row.high, ImGui::GetColorU32(ImGuiCol_HeaderHovered));
  }
  ImGui::SetCursorScreenPos(row.low);
  const bool clicked = ImGui::Selectable("##row", selected,
                                         ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_AllowItemOverlap,
                                         {row.high.x - row.low.x, row.high.y - row.low.y});
  row.hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
                ImGui::IsMouseHoveringRect(row.low, row.high);
  const bool plain = !ImGui::GetIO().KeyCtrl && !ImGui::GetIO().KeyShift;
  const bool twice = clicked && plain && ImGui::IsMouseDoubleClicked(0);
  if (row.isMuscle()) {
    ui.widgets.note("outliner/muscle/" + row.name());
    if (row.hovered) ui.state.frame.highlighted.push_back(row.row.index);
    dragSource(row);
    muscleMenu(ui, row.frame, row.row.index);
    const ImGuiIO& io = ImGui::GetIO();
    if (clicked && !twice) clickMuscle(ui.state, row.frame.rows, row.position, io.KeyShift, io.KeyCtrl);
    if (twice) startRename(ui.state, row.primitive().id());
  } else if (row.row.kind == RowKind::kBone) {
    ui.widgets.note("outliner/bone/" + row.name());
    dropTarget(row);
    boneMenu(ui, row.frame, row.row.index);
    if (clicked && !twice) clickBone(ui.state, row.row.index);
    if (twice && row.row.foldable) setFolded(ui.state, row.row.index, row.row.open, false);
  } else if (row.row.kind == RowKind::kPart) {
    ui.widgets.note("outliner/part/" + row.row.part);
    if (clicked) setPartFolded(ui.state, row.row.part, row.row.open);
  } else {
    ui.widgets.note("outliner/unattached");
    tooltip(ui, "Their bones are not in this character. They are kept and saved; drag one onto a bone to attach it.");
    if (clicked) ui.state.view.outliner.unattachedFolded = row.row.open;
  }
}

/// The full name if it was cut; not over the switches, which have their own tooltips.
void nameTooltip(const Row& row, bool cut, const std::string& name) {
  const bool over = row.hovered && !ImGui::IsMouseDown(0) && ImGui::GetMousePos().x < row.nameEnd();
  tooltipWhile(row.ui, cut && over, name);
}

void drawMuscle(Row& row) {
  PanelUi& ui = row.ui;
  const Primitive& primitive = row.primitive();
  const auto index = static_cast<std::size_t>(row.row.index);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool visible = row.frame.effective.visible[index];
  const bool attached = row.frame.boneOf[index] >= 0;
  const Tint tint = groupTint(*row.frame.rig, primitive.group);
  const Icon icon = !primitive.sheet.empty() ? Icon::kSheet : (primitive.sign > 0 ? Icon::kMuscle : Icon::kCarve);
  drawIcon(list, icon, {row.indent() + ui.px(15), row.middle(ui.px(13))}, ui.px(13),
           tint.faded(visible ? 1.0f : 0.4f).packed());
  if (ui.state.open.rename.primitive == primitive.id()) return;
  const Tint color = visible ? palette::kText : palette::kMuted.faded(0.6f);
  const float from = row.indent() + ui.px(kNameFrom);
  const float room = row.nameEnd() - from;
  const std::string name = shownMuscleName(*row.frame.rig, row.row.index);
  const std::string& bone = listedBone(*row.frame.rig, row.row.index);
  const std::string shown = attached ? name : name + "  (no bone " + bone + ")";
  const bool cut = clippedText(list, {from, row.middle(ImGui::GetTextLineHeight())}, room, color.packed(), shown,
                               row.frame.muscleEnds);
  nameTooltip(row, cut, shown);
}

void drawBone(Row& row) {
  PanelUi& ui = row.ui;
  const auto index = static_cast<std::size_t>(row.row.index);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool within = !row.frame.territory.empty() && row.frame.territory[index];
  const bool hidden = row.frame.effective.boneHidden[index];
  const Tint tint = within ? territoryTint() : palette::kMuted;
  if (within) {
    drawIcon(list, Icon::kTerritory, {row.indent() + ui.px(16), row.middle(ui.px(14))}, ui.px(14), tint.packed());
  } else {
    drawIcon(list, Icon::kBone, {row.indent() + ui.px(16), row.middle(ui.px(13))}, ui.px(13),
             tint.faded(hidden ? 0.4f : 0.8f).packed());
  }
  const float from = row.indent() + ui.px(kNameFrom);
  const Tint color = within ? territoryTint() : (hidden ? palette::kMuted.faded(0.6f) : palette::kText.faded(0.82f));
  const bool cut = clippedText(list, {from, row.middle(ImGui::GetTextLineHeight())}, row.nameEnd() - from,
                               color.packed(), row.frame.boneNames[index], row.frame.boneEnds);
  nameTooltip(row, cut || row.frame.boneNames[index] != row.bone().name, row.bone().name);
}

void drawAddCell(Row& row) {
  const bool selected = row.ui.state.document.selection.bone == row.row.index;
  if (!selected && !row.hovered) return;
  const std::string id = selected ? "outliner/add" : "outliner/add-hovered";
  if (cell(row, 3, id, Icon::kPlus, palette::kMuted, true, "Add muscle on this bone")) {
    addMuscle(row.ui.state, row.row.index);
  }
}

const char* titleOf(const OutlinerRow& row) { return row.kind == RowKind::kPart ? row.part.c_str() : "unattached"; }

void drawUnattachedHead(const Row& row) {
  ImGui::GetWindowDrawList()->AddText({row.indent() + row.ui.px(18), row.middle(ImGui::GetTextLineHeight())},
                                      palette::kWarning.packed(), "Unattached");
}

/// The name of a group, or its number if no font has the letters; or the part of the body.
std::string partTitle(const Row& row) {
  const int group = findGroup(*row.frame.rig, row.row.part);
  return group < 0 ? row.row.part : shownGroupName(*row.frame.rig, group);
}

void drawPartTitle(const Row& row) {
  const float from = row.indent() + row.ui.px(18);
  const bool cut = clippedText(*ImGui::GetWindowDrawList(), {from, row.middle(ImGui::GetTextLineHeight())},
                               row.high.x - from, palette::kText.faded(0.82f).packed(), partTitle(row));
  tooltipWhile(row.ui, cut && row.hovered, row.row.part);
}

}  // namespace

void drawOutlinerRow(PanelUi& ui, const OutlinerContent& frame, int position) {
  const OutlinerRow& entry = at(frame.rows, position);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  Row row{ui, frame, entry, position, low, {low.x + width, low.y + frame.rowHeight}};
  ImGui::PushID(static_cast<int>(entry.kind));
  ImGui::PushID(entry.kind == RowKind::kBone ? row.bone().path.c_str()
                                             : (row.isMuscle() ? row.primitive().name.c_str() : titleOf(entry)));
  const Selection& selection = ui.state.document.selection;
  const bool selected = row.isMuscle() ? selection.contains(row.primitive().id())
                                       : entry.kind == RowKind::kBone && selection.bone == entry.index;
  const bool renamed = row.isMuscle() && ui.state.open.rename.primitive == row.primitive().id();
  if (!renamed) drawBar(row, selected);
  if (row.isMuscle()) {
    drawMuscle(row);
  } else if (entry.kind == RowKind::kBone) {
    drawBone(row);
    drawAddCell(row);
  } else if (entry.kind == RowKind::kPart) {
    drawPartTitle(row);
  } else {
    drawUnattachedHead(row);
  }
  drawFold(row);
  if (renamed) {
    drawRename(row);
  } else if (entry.kind == RowKind::kMuscle || entry.kind == RowKind::kBone) {
    drawSwitches(row);
  }
  ImGui::PopID();
  ImGui::PopID();
  ImGui::SetCursorScreenPos({low.x, low.y + frame.rowHeight});
}

void keepDraggedShown(PanelUi& ui) {
  const ImGuiPayload* payload = ImGui::GetDragDropPayload();
  if (payload == nullptr || !payload->IsDataType(kMusclePayload)) return;
  const int index = *static_cast<const int*>(payload->Data);
  if (static_cast<std::size_t>(index) >= ui.state.document.rig().primitives.size()) return;
  if (!ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceExtern)) return;
  drawDragged(ui, index);
  ImGui::EndDragDropSource();
}

}  // namespace sinew::app
