// app/ui/ui.cpp: the controls that all panels share.

#include "app/ui/ui.h"

#include <imgui.h>
#include <imgui_internal.h>  // GetItemID, hover times and open popups, which 1.86 keeps to itself.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>

namespace sinew::app {
namespace {

constexpr float kLabelColumn = 84.0f;  // Design pixels.
constexpr double kTooltipSeconds = 0.45;

ImU32 iconColor(bool active, bool hovered) {
  if (active) return palette::kAccent.packed();
  return (hovered ? palette::kText : palette::kMuted).packed();
}

std::string lowered(const char* word) {
  std::string text = word;
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

void heading(Ui& ui, const char* text) {
  ImGui::PushFont(ui.fonts.strong);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
}

void mutedText(const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kMuted);
  ImGui::TextUnformatted(text);
  ImGui::PopStyleColor();
}

void tooltip(Ui& ui, const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  const double left = kTooltipSeconds - static_cast<double>(ImGui::GetCurrentContext()->HoveredIdTimer);
  if (ImGui::GetHoveredID() != 0 && left > 0.0) {
    ui.wakeAfter = left;
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(7)});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ui.px(320));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
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

void beginFilledSlider(Ui& ui, float fraction) {
  // Drawn before the slider, whose own frame is left out: so the number stands on the bar, not under it.
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high{low.x + ImGui::CalcItemWidth(), low.y + ImGui::GetFrameHeight()};
  const float end = low.x + std::clamp(fraction, 0.0f, 1.0f) * (high.x - low.x);
  const float left = std::max(end - ui.px(3), low.x);
  const float rounding = ImGui::GetStyle().FrameRounding;
  const bool lit = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low, high);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, ImGui::GetColorU32(lit ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), rounding);
  list.AddRectFilled(low, {end, high.y}, ImGui::GetColorU32(palette::kAccent.faded(lit ? 0.30f : 0.22f)), rounding);
  list.AddRectFilled({left, low.y}, {left + ui.px(3), high.y}, ImGui::GetColorU32(palette::kAccent), ui.px(1.5f));
  for (const ImGuiCol part : {ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered,
                              ImGuiCol_FrameBgActive}) {
    ImGui::PushStyleColor(part, palette::kAccent.faded(0.0f));
  }
}

void endFilledSlider() { ImGui::PopStyleColor(5); }

void beginRow(Ui& ui, const char* label) {
  ImGui::AlignTextToFramePadding();
  mutedText(label);
  ImGui::SameLine(ui.px(kLabelColumn) + ImGui::GetStyle().WindowPadding.x);
  ImGui::SetNextItemWidth(-1.0f);
}

void pushDialogStyle(Ui& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(16), ui.px(14)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
}

void popDialogStyle() { ImGui::PopStyleVar(3); }

bool closeMenuOnEscape() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (!ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false)) return false;
  // A menu goes with all its submenus: one alone would come back at once, as the pointer still lies on its entry.
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
    const std::string name = id + "/" + lowered(words[i]);
    if (ImGui::InvisibleButton(name.c_str(), {part, height})) clicked = i;
    ui.widgets.note(name);
    const bool lit = i == chosen;
    if (lit) {
      list.AddRectFilled({low.x + ui.px(2), low.y + ui.px(2)}, {low.x + part - ui.px(2), low.y + height - ui.px(2)},
                         palette::kLine.packed(), ui.px(4));
    }
    const ImVec2 text = ImGui::CalcTextSize(words[i]);
    const Tint color = lit || ImGui::IsItemHovered() ? palette::kText : palette::kMuted;
    list.AddText({low.x + 0.5f * (part - text.x), low.y + 0.5f * (height - text.y)}, color.packed(), words[i]);
  }
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy({width, height});
  return clicked;
}

void clippedText(ImDrawList& list, const ImVec2& at, float width, ImU32 color, const std::string& text) {
  if (width <= 0.0f) return;
  if (ImGui::CalcTextSize(text.c_str()).x <= width) {
    list.AddText(at, color, text.c_str());
    return;
  }
  // The end stays, as names that begin alike differ there: "rectus abd...upper L".
  const float room = std::max(width - ImGui::CalcTextSize("...").x, 0.0f);
  const char* const last = text.c_str() + text.size();
  const char* tail = last;
  for (const char* c = last; c > text.c_str() && ImGui::CalcTextSize(c, last).x <= 0.4f * room; --c) {
    if ((static_cast<unsigned char>(*c) & 0xC0u) != 0x80u) tail = c;
  }
  const float tailWidth = ImGui::CalcTextSize(tail, last).x;
  const char* end = last;
  ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), room - tailWidth, 0.0f, text.c_str(), last, &end);
  const std::string shown = std::string(text.c_str(), end) + "..." + tail;
  list.AddText(at, color, shown.c_str());
}

}  // namespace sinew::app
