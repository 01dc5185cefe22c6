// app/ui/ui.cpp: the controls that all panels share.
#include "app/ui/ui.h"

#include <imgui.h>
#include <imgui_internal.h>  // Hover times and open popups, which 1.86 keeps internal.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <string_view>

#include "app/ui/reading_order.h"
#include "core/geometry/nearest_name.h"

namespace sinew::app {
namespace {

constexpr float kLabelColumn = 84.0f;  // Design pixels, as all here.
constexpr float kWideRow = 220.0f;     // In less room a name stands above its fields.
constexpr double kTooltipSeconds = 0.45;
constexpr double kNextFrame = 1e-3;

ImU32 iconColor(bool active, bool hovered) {
  if (active) return palette::kAccent.packed();
  return (hovered ? palette::kText : palette::kMuted).packed();
}

/// In logical order.
std::string cutToFit(const std::string& text, float width, const SharedEnds& shared = {}) {
  const auto measure = [](std::string_view part) {
    if (part.empty()) return 0.0f;
    return ImGui::CalcTextSize(inReadingOrder(std::string(part)).c_str()).x;
  };
  return elided(text, width, measure, shared);
}

void showTooltip(Ui& ui, const std::string& text) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(7)});
  ImGui::BeginTooltip();
  if (ImGui::IsWindowAppearing()) ui.wakeIn(kNextFrame);  // The first frame only measures it; the next one shows it.
  ImGui::PushTextWrapPos(ui.px(320));
  ImGui::TextUnformatted(inReadingOrder(text).c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

}  // namespace

void heading(Ui& ui, const char* text) {
  ImGui::PushFont(ui.fonts.strong);
  ImGui::TextUnformatted(inReadingOrder(text).c_str());
  ImGui::PopFont();
}

void mutedText(const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kMuted);
  ImGui::TextUnformatted(inReadingOrder(text).c_str());
  ImGui::PopStyleColor();
}

void tooltip(Ui& ui, const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  const double left = kTooltipSeconds - static_cast<double>(ImGui::GetCurrentContext()->HoveredIdTimer);
  if (ImGui::GetHoveredID() != 0 && left > kNextFrame) {
    ui.wakeIn(left);
    return;
  }
  showTooltip(ui, text);
}

bool iconButton(Ui& ui, const std::string& id, Icon icon, bool active, float size, const std::string& hint) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(id.c_str(), {size, size});
  ui.widgets.note(id);
  const bool hovered = ImGui::IsItemHovered();
  tooltip(ui, hint);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{corner.x + size, corner.y + size};
  if (active || hovered) {
    const Tint back = active ? palette::kAccent.faded(0.20f) : palette::kText.faded(0.08f);
    list.AddRectFilled(corner, end, back.packed(), ui.px(5));
  }
  const float inner = std::min(size, std::max(size * 0.56f, ui.px(15)));
  const float margin = 0.5f * (size - inner);
  drawIcon(list, icon, {corner.x + margin, corner.y + margin}, inner, iconColor(active, hovered));
  return pressed;
}

bool pillButton(Ui& ui, const std::string& id, const char* label, bool active) {
  ImGui::PushStyleColor(ImGuiCol_Button, active ? palette::kAccent.faded(0.22f) : palette::kRaised.faded(0.0f));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, active ? palette::kAccent.faded(0.30f) : palette::kText.faded(0.08f));
  ImGui::PushStyleColor(ImGuiCol_Text, active ? palette::kText : palette::kMuted);
  ImGui::PushID(id.c_str());
  const bool pressed = ImGui::Button(label);
  ImGui::PopID();
  ImGui::PopStyleColor(3);
  ui.widgets.note(id);
  return pressed;
}

void beginRow(Ui& ui, const char* label) {
  const float room = ImGui::GetContentRegionAvail().x;
  const float left = ImGui::GetCursorPosX();
  const float column = std::min(ui.px(kLabelColumn), 0.4f * room);
  const std::string shown = fitted(label, column - ui.px(4));
  ImGui::AlignTextToFramePadding();
  mutedText(shown.c_str());
  if (shown != label) tooltip(ui, label);
  ImGui::SameLine(left + column);
  ImGui::SetNextItemWidth(-1.0f);
}

void beginWideRow(Ui& ui, const char* label) {
  if (ImGui::GetContentRegionAvail().x >= ui.px(kWideRow)) {
    beginRow(ui, label);
    return;
  }
  mutedText(label);
  ImGui::SetNextItemWidth(-1.0f);
}

void pushDialogStyle(Ui& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(16), ui.px(14)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
}

void popDialogStyle() { ImGui::PopStyleVar(3); }

void placeDialog(Ui& ui, float designWidth) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const ImVec2 most{display.x - ui.px(16), display.y - ui.px(16)};
  ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, most);
  ImGui::SetNextWindowSize({std::min(ui.px(designWidth), most.x), 0.0f});
}

bool closeMenuOnEscape() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (!ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false)) return false;
  // Closes all submenus: the pointer would reopen a single one at once.
  int level = context.OpenPopupStack.Size;
  const auto isModal = [&](int popup) {
    const ImGuiWindow* window = context.OpenPopupStack[popup].Window;
    return window != nullptr && (window->Flags & ImGuiWindowFlags_Modal) != 0;
  };
  while (level > 0 && !isModal(level - 1)) --level;
  if (level == context.OpenPopupStack.Size) return false;
  ImGui::ClosePopupToLevel(level, true);
  return true;
}

bool escapePressed(const Ui& ui) { return !ui.escapeTaken && ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false); }

int segmented(Ui& ui, const std::string& id, const char* const* words, int count, int chosen, float width) {
  int clicked = -1;
  const float height = ImGui::GetFrameHeight();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg), ui.px(5));
  const float part = width / static_cast<float>(count);
  for (int i = 0; i < count; ++i) {
    const ImVec2 low{corner.x + part * static_cast<float>(i), corner.y};
    ImGui::SetCursorScreenPos(low);
    const std::string name = id + "/" + lowerCase(words[i]);
    if (ImGui::InvisibleButton(name.c_str(), {part, height})) clicked = i;
    ui.widgets.note(name);
    const bool lit = i == chosen;
    if (lit) {
      list.AddRectFilled({low.x + ui.px(2), low.y + ui.px(2)}, {low.x + part - ui.px(2), low.y + height - ui.px(2)},
                         palette::kLine.packed(), ui.px(4));
    }
    const ImVec2 text = ImGui::CalcTextSize(words[i]);
    const Tint color = lit || ImGui::IsItemHovered() ? palette::kText : palette::kMuted;
    const float room = std::min(text.x, part - ui.px(4));
    clippedText(list, {low.x + 0.5f * (part - room), low.y + 0.5f * (height - text.y)}, room, color.packed(), words[i]);
  }
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy({width, height});
  return clicked;
}

std::string fitted(const std::string& text, float width, const SharedEnds& shared) {
  return inReadingOrder(cutToFit(text, width, shared));
}

bool clippedText(ImDrawList& list, const ImVec2& at, float width, ImU32 color, const std::string& text,
                 const SharedEnds& shared) {
  if (width <= 0.0f) return !text.empty();
  const std::string cut = cutToFit(text, width, shared);
  const std::string shown = inReadingOrder(cut);
  if (ImGui::CalcTextSize(shown.c_str()).x <= width) list.AddText(at, color, shown.c_str());
  return cut != text;
}

void mutedLine(Ui& ui, const std::string& text) {
  const std::string shown = cutToFit(text, ImGui::GetContentRegionAvail().x);
  mutedText(shown.c_str());
  if (shown != text) tooltip(ui, text);
}

void tooltipWhile(Ui& ui, bool over, const std::string& text) {
  if (over) showTooltip(ui, text);
}

std::size_t fittingCount(std::span<const float> widths, float room, float more) {
  float used = 0.0f;
  std::size_t withMore = 0;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    used += widths[i];
    if (used > room) return withMore;
    if (used + more <= room) withMore = i + 1;
  }
  return widths.size();
}

bool beginMore(Ui& ui, const std::string& id, const ImVec2& size) {
  ImGui::PushID(id.c_str());
  const bool pressed = ImGui::Button("\xc2\xbb", size);
  ui.widgets.note(id);
  tooltip(ui, "More");
  if (pressed) ImGui::OpenPopup("more");
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(8)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), ui.px(6)});
  const bool open = ImGui::BeginPopup("more");
  if (open) return true;
  ImGui::PopStyleVar(2);
  ImGui::PopID();
  return false;
}

void endMore() {
  ImGui::EndPopup();
  ImGui::PopStyleVar(2);
  ImGui::PopID();
}

}  // namespace sinew::app
