// app/panels/palette.cpp: the palette (Ctrl+P), which finds actions, controls and things by a few letters.

#include <imgui_stdlib.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/panels/dialogs.h"
#include "app/panels/palette_entries.h"
#include "app/ui/reading_order.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

constexpr const char* kPaletteTitle = "palette";
constexpr float kPaletteWidth = 580.0f;  // Design pixels.
constexpr int kPaletteRows = 11;
constexpr std::size_t kMostFound = 200;

/// The label, with the matched letters in the accent color.
void drawMarked(ImDrawList& list, ImVec2 at, const std::string& text, const std::vector<std::size_t>& marks,
                Tint tint) {
  const std::string whole = inReadingOrder(text);
  if (whole != text) {  // The order of the letters differs from that of the bytes.
    list.AddText(at, tint.packed(), whole.c_str());
    return;
  }
  std::size_t begin = 0;
  while (begin < text.size()) {
    const bool marked = std::ranges::binary_search(marks, begin);
    std::size_t end = begin + 1;
    while (end < text.size() && std::ranges::binary_search(marks, end) == marked) ++end;
    const char* first = text.c_str() + begin;
    const char* last = text.c_str() + end;
    list.AddText(at, (marked ? palette::kAccent : tint).packed(), first, last);
    at.x += ImGui::CalcTextSize(first, last).x;
    begin = end;
  }
}

/// @return whether it was clicked
bool drawRow(PanelUi& ui, const PaletteEntry& entry, const Candidate& candidate, const Found& found, bool chosen,
             float height) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::PushID(entry.id.c_str());
  const bool clicked = ImGui::Selectable("##row", chosen, ImGuiSelectableFlags_DontClosePopups, {0.0f, height});
  ImGui::PopID();
  ui.widgets.note("palette/" + entry.id);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = corner.y + 0.5f * (height - ImGui::GetTextLineHeight());
  drawIcon(list, iconOf(entry), {corner.x + ui.px(6), corner.y + 0.5f * (height - ui.px(14))}, ui.px(14),
           palette::kMuted.packed());
  drawMarked(list, {corner.x + ui.px(30), middle}, candidate.label, found.marks,
             candidate.usable ? palette::kText : palette::kMuted.faded(0.6f));
  const float right = corner.x + ImGui::GetContentRegionAvail().x - ui.px(8);
  const bool usable = candidate.usable;  // The reason takes the place of the keys if the entry cannot be used.
  const std::string keys = usable && entry.action != nullptr ? keyText(*entry.action, ui.state) : entry.why;
  const float keysWidth = keys.empty() ? 0.0f : ImGui::CalcTextSize(keys.c_str()).x;
  list.AddText({right - keysWidth, middle}, (usable ? palette::kText : palette::kMuted).packed(), keys.c_str());
  const float contextLeft =
      corner.x + ui.px(30) + ImGui::CalcTextSize(inReadingOrder(candidate.label).c_str()).x + ui.px(12);
  list.PushClipRect({contextLeft, corner.y}, {right - keysWidth - ui.px(12), corner.y + height}, true);
  list.AddText({contextLeft, middle}, palette::kMuted.faded(0.8f).packed(), inReadingOrder(candidate.context).c_str());
  list.PopClipRect();
  return clicked;
}

/// Up, Down, Page Up and Page Down move the choice. @param chosen  -1: none  @return the new choice
int movedChoice(int chosen, int count) {
  if (count == 0) return -1;
  if (ImGui::IsKeyPressed(GLFW_KEY_DOWN)) return (chosen + 1) % count;
  if (ImGui::IsKeyPressed(GLFW_KEY_UP)) return chosen <= 0 ? count - 1 : chosen - 1;
  if (ImGui::IsKeyPressed(GLFW_KEY_PAGE_DOWN)) return std::min(chosen + kPaletteRows, count - 1);
  if (ImGui::IsKeyPressed(GLFW_KEY_PAGE_UP)) return std::max(chosen - kPaletteRows, 0);
  return chosen;
}

/// @return the row that was clicked, or -1
int drawFound(PanelUi& ui, const PaletteEntries& all, const std::vector<Found>& found, int lit, bool moved) {
  int taken = -1;
  const float height = ImGui::GetTextLineHeight() + ui.px(10);
  const int rows = std::clamp(static_cast<int>(found.size()), 1, kPaletteRows);
  ImGui::BeginChild("found", {0.0f, static_cast<float>(rows) * height});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::size_t index = found[i].index;
    const bool chosen = static_cast<int>(i) == lit;
    if (drawRow(ui, all.entries[index], all.candidates[index], found[i], chosen, height)) taken = static_cast<int>(i);
    if (chosen && moved && !ImGui::IsItemVisible()) ImGui::SetScrollHereY(0.5f);
  }
  if (found.empty()) {
    ImGui::SetCursorPos({ui.px(30), ui.px(8)});
    mutedText("Nothing found.");
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
  return taken;
}

void drawContents(PanelUi& ui) {
  PaletteState& palette = ui.state.dialogs.palette;
  if (palette.appearing) ImGui::SetKeyboardFocusHere();
  palette.appearing = false;
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered =
      ImGui::InputTextWithHint("##query", "Actions, controls, muscles, bones, parts, clips, sets, samples, pages",
                               &palette.query, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note("palette/query");
  if (ImGui::IsItemEdited()) palette.chosen = -1;
  const PaletteEntries all = gatherEntries(ui.state);
  const std::vector<Found> found = search(palette.query, all.candidates, kMostFound);
  const int count = static_cast<int>(found.size());
  const int before = palette.chosen >= 0 ? std::min(palette.chosen, count - 1) : preselected(found, all.candidates);
  const int lit = movedChoice(before, count);
  if (lit != before) palette.chosen = lit;
  int taken = drawFound(ui, all, found, lit, lit != before);
  if (entered) taken = lit;
  const bool usable = taken >= 0 && all.candidates[at(found, taken).index].usable;
  if (usable || ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false)) {
    ui.state.dialogs.palette = {};
    ImGui::CloseCurrentPopup();
  } else if (entered || taken >= 0) {
    palette.appearing = true;  // An entry that cannot be used leaves the palette open.
  }
  if (usable) chooseEntry(ui.state, all.entries[at(found, taken).index]);
}

}  // namespace

void drawPalette(PanelUi& ui) {
  if (!ui.state.dialogs.palette.shown) return;
  if (ui.state.dialogs.palette.appearing && !ImGui::IsPopupOpen(kPaletteTitle)) ImGui::OpenPopup(kPaletteTitle);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float width = std::min(ui.px(kPaletteWidth), display.x - ui.px(20));
  ImGui::SetNextWindowPos({0.5f * display.x, 0.14f * display.y}, ImGuiCond_Always, {0.5f, 0.0f});
  ImGui::SetNextWindowSize({width, 0.0f});
  pushDialogStyle(ui);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(10)});
  const bool open = ImGui::BeginPopup(kPaletteTitle, ImGuiWindowFlags_NoMove);
  if (open) {
    drawContents(ui);
    ImGui::EndPopup();
  } else {
    ui.state.dialogs.palette = {};  // Closed by a click beside it.
  }
  ImGui::PopStyleVar();
  popDialogStyle();
}

}  // namespace sinew::app
